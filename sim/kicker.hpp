// A robot's kicker, straight and chip.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/geometry.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::sim {

// The ball's velocity over ground after a kick: along the heading, that of the kick; across it, the
// ball's own, since the plate pushes it only forwards.
struct Kick {
  Vec2 velocity_mps{0, 0};
  double vertical_mps = 0;
};

class Kicker {
 public:
  // `substeps_per_s` is the call rate of fire().
  Kicker(const KickerParameters& parameters, double substeps_per_s);

  // Fires if commanded, with the ball in the dribbler zone and the kicker charged. A chip's
  // commanded speed is its total speed, at the chip angle.
  std::optional<Kick> fire(const RobotCommand& command, const BodyState& robot,
                           const BodyState& ball, double ball_height_m, std::int64_t substep,
                           RandomStream& noise);

  // Whether it fired less than its dead time ago.
  bool is_recharging(std::int64_t substep) const { return substep < ready_at_; }

  // The maximum ball speed of a straight kick.
  double speed_limit_mps() const { return parameters_.speed_limit_mps; }

 private:
  SinCos chip_angle(RandomStream& noise) const;
  Kick make(const RobotCommand& command, const Vec2& heading, RandomStream& noise) const;

  KickerParameters parameters_;
  std::int64_t dead_substeps_;
  SinCos chip_angle_;
  std::int64_t ready_at_ = 0;  // sub-step
};

}  // namespace autoref::sim
