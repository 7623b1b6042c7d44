// The robot's kicker and dribbler.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/box2d_bridge.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/geometry.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::sim {

// Whether a ball at `ball_m`, whose lowest point is at `height_m`, is in the robot's dribbler zone:
// its surface is within `reach_m` of the plate, its centre is within the zone's width, and it is
// low enough for the roller, which is as high as the centre of a ball on the carpet.
template <typename Robot>  // BodyState or RobotState
bool is_in_dribbler_zone(const Robot& robot, const Vec2& ball_m, double height_m, double reach_m) {
  if (height_m > kBallRadius_m) return false;
  const Vec2 local_m = to_local(ball_m - robot.position_m, robot.heading);
  return local_m.x() > kFrontDistance_m &&
         local_m.x() <= kFrontDistance_m + kBallRadius_m + reach_m &&
         std::abs(local_m.y()) <= kDribblerZoneWidth_m / 2.0;
}

// An ordinary dribbler pulls the ball towards the plate's centre and damps its motion relative to
// the plate, so hard turns and sideways jerks lose it. Its maximum force is drawn each time it gets
// hold of the ball. A holding dribbler immediately cancels all relative motion and centres the ball
// at up to centring_mps, so the ball is never faster than the plate by more than that.
class Dribbler {
 public:
  // `substeps_per_s` is the rate at which sub-steps are counted.
  Dribbler(const DribblerParameters& parameters, double ball_mass_kg, double substeps_per_s);

  // The force in newtons, in field coordinates, of the running dribbler on the ball during the next
  // `duration_s`; zero if the ball is out of reach. Draws a random number only if there is noise
  // and the dribbler has not pulled for a tenth of a second.
  Vec2 force_n(const BodyState& robot, const BodyState& ball, double ball_height_m,
               double duration_s, std::int64_t substep, RandomStream& noise);

  bool holds() const { return parameters_.holds; }

  // The maximum force in the current grip.
  double limit_n() const { return limit_n_; }

 private:
  Vec2 pull_n(const BodyState& robot, const BodyState& ball) const;
  Vec2 hold_n(const BodyState& robot, const BodyState& ball, double duration_s) const;

  DribblerParameters parameters_;
  double ball_mass_kg_;
  std::int64_t pause_substeps_;   // a shorter pause does not end a grip
  double limit_n_;                // maximum force in this grip
  std::int64_t grips_until_ = 0;  // sub-step at which the grip ends
};

// The ball's velocity over ground after a kick. Along the heading, it is the kick's velocity.
// Across the heading, the ball keeps its own velocity, since the plate only pushes it forwards.
struct Kick {
  Vec2 velocity_mps{0, 0};
  double vertical_mps = 0;
};

class Kicker {
 public:
  // `substeps_per_s` is the rate at which fire() is called.
  Kicker(const KickerParameters& parameters, double substeps_per_s);

  // Fires if commanded, the ball is in the dribbler zone and the kicker is charged. A chip's
  // commanded speed is its total speed, at the chip angle.
  std::optional<Kick> fire(const RobotCommand& command, const BodyState& robot,
                           const BodyState& ball, double ball_height_m, std::int64_t substep,
                           RandomStream& noise);

  // Whether the kicker fired less than its dead time ago.
  bool is_recharging(std::int64_t substep) const { return substep < ready_at_; }

  // The maximum ball speed of a straight kick.
  double speed_limit_mps() const { return parameters_.speed_limit_mps; }

 private:
  SinCos chip_angle(RandomStream& noise) const;
  Kick make(const RobotCommand& command, const Vec2& heading, RandomStream& noise) const;

  KickerParameters parameters_;
  std::int64_t dead_substeps_;
  SinCos chip_angle_;
  std::int64_t ready_at_ = 0;  // sub-step at which the kicker is ready again
};

}  // namespace autoref::sim
