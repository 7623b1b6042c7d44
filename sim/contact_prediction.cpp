#include "sim/contact_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

constexpr double kSpare_m = 5_mm;    // well above Box2D's slop of half a millimetre
constexpr double kGentle_mps = 0.5;  // slower robot collisions may happen in longer steps

}  // namespace

ContactPrediction::ContactPrediction(const Field& field, const PerSide<TeamSpec>& specs,
                                     double duration_s)
    : field_(field), duration_s_(duration_s), margin_m_(kSpare_m) {
  for (const TeamSpec& spec : specs.values) {
    for (const RobotSpec& robot : spec.robots) {
      const double most_mps2 = robot.acceleration_factor *
                               std::max(robot.body.acceleration_mps2, robot.body.braking_mps2);
      // Acceleration can move a body a t^2 / 2 off its predicted path; this allows twice as much.
      margin_m_ = std::max(margin_m_, kSpare_m + most_mps2 * duration_s * duration_s);
      dribbler_zone_m_ = std::max({dribbler_zone_m_, robot.kicker.reach_m, robot.dribbler.reach_m});
    }
  }
}

bool ContactPrediction::is_contact_free(const Box2dBridge& bodies, int robots,
                                        bool is_ball_held) const {
  const BodyState& ball = bodies.ball();
  const double ball_reach_m = reach_m(ball, kBallRadius_m);
  if (ball_reach_m - kBallRadius_m > kLongestStep_m) return false;
  if (!keeps_off_walls(ball.position_m, ball_reach_m)) return false;
  for (int i = 0; i < robots && !is_ball_held; ++i) {
    if (!bodies.is_on(i)) continue;
    const BodyState& robot = bodies.robot(i);
    const double near_m = reach_m(robot, kRobotRadius_m) + dribbler_zone_m_ + ball_reach_m;
    if ((robot.position_m - ball.position_m).squaredNorm() < near_m * near_m) return false;
  }
  return robots_keep_apart(bodies, robots);
}

// Radius of a disc that contains the body until the end of the step.
double ContactPrediction::reach_m(const BodyState& body, double radius_m) const {
  return radius_m + margin_m_ + body.velocity_mps.norm() * duration_s_;
}

// Conservative: behind the goal line, everything between the goal's outer walls counts as blocked,
// even its opening.
bool ContactPrediction::keeps_off_walls(const Vec2& at_m, double reach_m) const {
  const double x = std::abs(at_m.x()) + reach_m;
  const double y = std::abs(at_m.y());
  if (x > field_.wall_x_m() || y + reach_m > field_.wall_y_m()) return false;
  const double goal_y_m = field_.half_goal_m() + field_.goal_wall_thickness_m;
  return x < field_.half_length_m() || y - reach_m > goal_y_m;
}

// Pairwise test of the discs that contain each robot's motion during the step. Overlapping discs
// are allowed if the robots approach each other slowly.
bool ContactPrediction::robots_keep_apart(const Box2dBridge& bodies, int robots) const {
  std::array<double, 2 * kMaxRobots> reaches_m;
  for (int i = 0; i < robots; ++i) {
    if (!bodies.is_on(i)) continue;
    const BodyState& robot = bodies.robot(i);
    const double its_reach_m = reach_m(robot, kRobotRadius_m);
    if (its_reach_m - kRobotRadius_m > kLongestStep_m) return false;
    if (!keeps_off_walls(robot.position_m, its_reach_m)) return false;
    reaches_m[static_cast<std::size_t>(i)] = its_reach_m;
    for (int k = 0; k < i; ++k) {
      if (!bodies.is_on(k)) continue;
      const double near_m = its_reach_m + reaches_m[static_cast<std::size_t>(k)];
      const BodyState& other = bodies.robot(k);
      const Vec2 apart_m = other.position_m - robot.position_m;
      const double apart2_m2 = apart_m.squaredNorm();
      if (apart2_m2 >= near_m * near_m) continue;
      // Closing speed times distance, to be compared without a division.
      const double closing = (robot.velocity_mps - other.velocity_mps).dot(apart_m);
      if (closing > kGentle_mps * std::sqrt(apart2_m2)) return false;
    }
  }
  return true;
}

}  // namespace autoref::sim
