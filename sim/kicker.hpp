// A robot's kicker, flat and chip.
#pragma once

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

class Kicker {
 public:
  // `substeps_per_s` is the rate of the calls to fire().
  Kicker(const KickerParameters& parameters, double substeps_per_s);

  // Fires if it is ordered to, has the ball in its mouth, and is charged. A chip's speed is the
  // total one, at the chip angle.
  std::optional<Kick> fire(const RobotCommand& command, const BodyState& robot, const Vec2& ball_m,
                           double ball_height_m, std::int64_t substep, RandomStream& noise);

  // Whether it fired less than its dead time ago.
  bool is_recharging(std::int64_t substep) const { return substep < ready_at_; }

  // The most it gives a ball straight.
  double speed_limit_mps() const { return parameters_.speed_limit_mps; }

 private:
  Kick make(const RobotCommand& command, const Vec2& heading, RandomStream& noise) const;

  KickerParameters parameters_;
  std::int64_t dead_substeps_;
  double chip_sin_;
  double chip_cos_;
  std::int64_t ready_at_ = 0;  // sub-step
};

}  // namespace autoref::sim
