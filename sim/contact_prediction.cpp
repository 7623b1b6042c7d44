#include "sim/contact_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

constexpr double kSpare_m = 1_mm;    // twice Box2D's slop
constexpr double kGentle_mps = 0.5;  // robot collisions slower than this may happen in longer steps

// Compares closing speed times distance, which avoids a division.
bool is_hard(const BodyState& a, const BodyState& b) {
  const Vec2 apart_m = b.position_m - a.position_m;
  const double closing = (a.velocity_mps - b.velocity_mps).dot(apart_m);
  return closing > kGentle_mps * apart_m.norm();
}

}  // namespace

ContactPrediction::ContactPrediction(const Field& field, const PerSide<TeamSpec>& specs,
                                     double duration_s)
    : field_(field), duration_s_(duration_s), margin_m_(kSpare_m) {
  for (const TeamSpec& spec : specs.values) {
    for (const RobotSpec& robot : spec.robots) {
      const double most_mps2 = robot.acceleration_factor *
                               std::max(robot.body.acceleration_mps2, robot.body.braking_mps2);
      // Acceleration can move a body a t^2 / 2 away from its predicted path; the margin allows for
      // twice as much.
      margin_m_ = std::max(margin_m_, kSpare_m + most_mps2 * duration_s * duration_s);
      dribbler_zone_m_ = std::max({dribbler_zone_m_, robot.kicker.reach_m, robot.dribbler.reach_m});
    }
  }
}

Encounters ContactPrediction::encounters(const Box2dBridge& bodies, int robots,
                                         bool is_ball_held) const {
  Encounters found;
  Discs discs;
  for (int i = 0; i < robots; ++i) {
    if (!bodies.is_on(i)) continue;
    const BodyState& robot = bodies.robot(i);
    discs.push_back({robot.position_m, reach_m(robot, kRobotRadius_m), i});
  }
  for (const Disc& disc : discs) {
    if (keeps_off_walls(disc.centre_m, disc.radius_m)) continue;
    found.bodies.add_robot(disc.index);
    found.need_short_steps = true;
  }
  add_pairs(bodies, discs, found);
  add_ball(bodies, is_ball_held ? Discs{} : discs, found);
  return found;
}

void ContactPrediction::add_pairs(const Box2dBridge& bodies, const Discs& discs,
                                  Encounters& found) const {
  for (const Disc& disc : discs) {
    for (const Disc* other = discs.data(); other != &disc; ++other) {
      if (!disc.overlaps(other->centre_m, other->radius_m)) continue;
      const BodyState& one_body = bodies.robot(disc.index);
      const BodyState& other_body = bodies.robot(other->index);
      if (!can_meet(one_body, other_body, 2.0 * kRobotRadius_m)) continue;
      found.bodies.add_robot(disc.index);
      found.bodies.add_robot(other->index);
      if (is_hard(one_body, other_body)) found.need_short_steps = true;
    }
  }
}

void ContactPrediction::add_ball(const Box2dBridge& bodies, const Discs& discs,
                                 Encounters& found) const {
  const BodyState& ball = bodies.ball();
  const double ball_reach_m = reach_m(ball, kBallRadius_m);
  found.bodies.ball = !keeps_off_walls(ball.position_m, ball_reach_m);
  for (const Disc& disc : discs) {
    if (!disc.overlaps(ball.position_m, dribbler_zone_m_ + ball_reach_m)) continue;
    if (!can_meet(bodies.robot(disc.index), ball,
                  kRobotRadius_m + dribbler_zone_m_ + kBallRadius_m)) {
      continue;
    }
    found.bodies.add_robot(disc.index);
    found.bodies.ball = true;
  }
  if (found.bodies.ball) found.need_short_steps = true;
}

// Whether the centres come within `touching_m` and the margins of each other.
bool ContactPrediction::can_meet(const BodyState& a, const BodyState& b, double touching_m) const {
  const Vec2 apart_m = b.position_m - a.position_m;
  const Vec2 closing_mps = b.velocity_mps - a.velocity_mps;
  const double along = -apart_m.dot(closing_mps);
  const double speed2 = closing_mps.squaredNorm();
  const double until_s = along <= 0.0                    ? 0.0
                         : along >= speed2 * duration_s_ ? duration_s_
                                                         : along / speed2;
  const double near_m = touching_m + 2.0 * margin_m_;
  return (apart_m + until_s * closing_mps).squaredNorm() < near_m * near_m;
}

// The radius of the disc that contains the body until the end of the step.
double ContactPrediction::reach_m(const BodyState& body, double radius_m) const {
  return radius_m + margin_m_ + body.velocity_mps.norm() * duration_s_;
}

// This is conservative: behind the goal line, everything between the goal's outer walls counts as
// blocked, even its opening.
bool ContactPrediction::keeps_off_walls(const Vec2& at_m, double reach_m) const {
  const double x = std::abs(at_m.x()) + reach_m;
  const double y = std::abs(at_m.y());
  if (x > field_.wall_x_m() || y + reach_m > field_.wall_y_m()) return false;
  const double goal_y_m = field_.half_goal_m() + field_.goal_wall_thickness_m;
  return x < field_.half_length_m() || y - reach_m > goal_y_m;
}

}  // namespace autoref::sim
