// The kickers of one side's robots, flat and chip.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/geometry.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"

namespace autoref::sim {

// The speed a kick gives the ball, over ground.
struct Kick {
  Vec2 velocity_mps{0, 0};
  double vertical_mps = 0;
};

class Kickers {
 public:
  // `substeps_per_s` is the rate of the calls to fire().
  Kickers(const KickerParameters& parameters, double substeps_per_s, RandomStream noise);

  // Fires robot `number`'s kicker if it is ordered to, has the ball in its mouth, and is charged.
  // A chip's speed is the total one, at the chip angle.
  std::optional<Kick> fire(int number, const RobotCommand& order, const BodyState& robot,
                           const Vec2& ball_m, double ball_height_m, std::int64_t substep);

 private:
  Kick make(const RobotCommand& order, const Vec2& heading);

  KickerParameters parameters_;
  std::int64_t dead_substeps_;
  double chip_sin_;
  double chip_cos_;
  RandomStream noise_;
  std::array<std::int64_t, kMaxRobots> ready_at_{};  // sub-step, by robot number
};

}  // namespace autoref::sim
