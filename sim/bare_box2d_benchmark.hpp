// A fixed Box2D scene to measure whole games against: what bare physics of this size costs.
//
// 12 robots of eight vertices with a flat front on a 9 x 6 m field, velocities set each 60 Hz frame
// towards random targets, one bullet ball that is kicked when reached, 10 static edges, 8 velocity
// and 3 position iterations, 240 Hz, 10 units a metre, no clock reads. It must never change: its
// only use is that figures stay comparable.
#pragma once

#include <cstdint>
#include <memory>

namespace autoref::sim {

class BareBox2dBenchmark {
 public:
  explicit BareBox2dBenchmark(std::uint64_t seed);
  ~BareBox2dBenchmark();
  BareBox2dBenchmark(const BareBox2dBenchmark&) = delete;
  BareBox2dBenchmark& operator=(const BareBox2dBenchmark&) = delete;

  // One 60 Hz frame: four steps of the world.
  void step_frame();

  // Changes with every body's place, so that no compiler leaves the work out.
  double checksum_m() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace autoref::sim
