#include "strategies/basic/positions.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::strategies::basic {
namespace {

Waypoint facing_ball(const Vec2& position_m, const Vec2& ball_m) {
  return {position_m, direction_of(ball_m - position_m, Vec2(1, 0))};
}

Vec2 own_goal_m(const Field& field) { return field.goal_centre_m(Side::kWest); }

}  // namespace

Waypoint keeper_position(const Field& field, const Style& style, const TrackedBall& ball) {
  const double line_x = -field.half_length_m() + kRobotRadius_m + style.margin_m;
  const double reach_m = field.half_goal_m() - kRobotRadius_m / 2;
  // At a shot, the keeper stands where the ball's straight path crosses the keeper's line.
  // Otherwise its offset from the middle is proportional to the sine of the ball's direction.
  double y = 0;
  if (ball.velocity_mps.x() < -style.keeper_shot_mps && ball.position_m.x() > line_x) {
    y = ball.position_m.y() +
        ball.velocity_mps.y() * (line_x - ball.position_m.x()) / ball.velocity_mps.x();
  } else {
    const Vec2 goal_m = own_goal_m(field);
    const Vec2 direction = direction_of(ball.position_m - goal_m, Vec2(1, 0));
    y = direction.y() * field.half_goal_m();
  }
  return facing_ball({line_x, std::clamp(y, -reach_m, reach_m)}, ball.position_m);
}

Waypoint wall_position(const Field& field, const Style& style, const Vec2& ball_m, int order) {
  const Vec2 goal_m = own_goal_m(field);
  const Vec2 direction = direction_of(ball_m - goal_m, Vec2(1, 0));
  // The approximate distance from the goal to the area's edge: the area's depth straight ahead, and
  // more towards the sides.
  const double off_m = field.defence_area.depth_m +
                       field.defence_area.straight_m / 2 * std::abs(direction.y()) +
                       kRobotRadius_m + 2 * style.margin_m;
  // The second robot stands on the side of the middle, as close to the first as obstacle avoidance
  // allows.
  const double aside = ball_m.y() > 0 ? -1.0 : 1.0;
  return facing_ball(
      goal_m + direction * off_m + left_of(direction) * (aside * style.wall_gap_m * order), ball_m);
}

Waypoint marker_position(const Field& field, const Style& style, const TrackedRobot& opponent,
                         const Vec2& ball_m) {
  const Vec2 to_goal = direction_of(own_goal_m(field) - opponent.position_m, Vec2(-1, 0));
  return facing_ball(opponent.position_m + to_goal * (style.mark_radii * kRobotRadius_m), ball_m);
}

Waypoint supporter_position(const Field& field, const Style& style, const Vec2& ball_m, int order) {
  const double away = ball_m.y() > 0 ? -1.0 : 1.0;
  const double ahead = std::clamp(ball_m.x() / field.half_length_m() + style.supporter_ahead,
                                  style.supporter_back, style.supporter_front);
  // Pairs of positions on both wings, each pair one row nearer to the team's own goal.
  const int row = order / 2;
  const double wing = order % 2 == 0 ? away : -away;
  const double x = std::max(ahead - style.supporter_row * row, -0.5) * field.half_length_m();
  const double y = wing * (style.supporter_wing - 0.1 * row) * field.half_width_m();
  return facing_ball({x, y}, ball_m);
}

Waypoint reserve_position(const Field& field, const Vec2& ball_m, int index) {
  const double side = index % 2 == 0 ? 1.0 : -1.0;
  const int row = index / 2;
  const double x = -0.35 * field.half_length_m() + 0.12 * field.half_length_m() * row;
  return facing_ball({x, side * (0.35 + 0.1 * row) * field.half_width_m()}, ball_m);
}

}  // namespace autoref::strategies::basic
