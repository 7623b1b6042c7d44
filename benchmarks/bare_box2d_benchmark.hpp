// A fixed Box2D scene as the baseline for the speed of whole games: the cost of bare physics at
// this scale.
//
// 12 robots of eight vertices with a flat front on a 9 x 6 m field, velocities set each 60 Hz frame
// towards random targets, one bullet ball that is kicked when reached, 10 static edges, 8 velocity
// and 3 position iterations, 240 Hz, 10 units per metre, no clock reads. The scene must never
// change, so that measurements stay comparable.
#pragma once

#include <cstdint>
#include <memory>

namespace autoref::benchmarks {

class BareBox2dBenchmark {
 public:
  explicit BareBox2dBenchmark(std::uint64_t seed);
  ~BareBox2dBenchmark();
  BareBox2dBenchmark(const BareBox2dBenchmark&) = delete;
  BareBox2dBenchmark& operator=(const BareBox2dBenchmark&) = delete;

  // One 60 Hz frame: four steps of the world.
  void step_frame();

  // Depends on every body's position, so that the compiler cannot optimise the simulation away.
  double checksum_m() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace autoref::benchmarks
