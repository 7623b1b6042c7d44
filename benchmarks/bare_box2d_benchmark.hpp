// A fixed Box2D scene as the baseline for the speed of whole games: the cost of bare physics at
// this scale.
//
// 12 robots with eight vertices and a flat front drive on a 9 x 6 m field with 10 static edges. In
// each 60 Hz frame, their velocities are set towards random targets. One ball, a bullet in Box2D's
// terms, is kicked when a robot reaches it. The scene is simulated at 240 Hz with 8 velocity and 3
// position iterations, 10 units per metre, and no clock reads. It must never change, so that
// measurements stay comparable.
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

  // A sum that depends on every body's position, so that the compiler cannot optimise the
  // simulation away.
  double checksum_m() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace autoref::benchmarks
