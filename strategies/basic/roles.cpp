#include "strategies/basic/roles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autoref::strategies::basic {
namespace {

Waypoint facing_ball(const Vec2& position_m, const Vec2& ball_m) {
  return {position_m, direction_of(ball_m - position_m, Vec2(1, 0))};
}

Vec2 own_goal_m(const Field& field) { return field.goal_centre_m(Side::kWest); }

using Taken = std::array<bool, kMaxRobots>;

// The time in seconds that the robot needs to get behind the ball, as seen from the opponents'
// goal.
double time_behind_ball_s(const TrackedRobot& robot, const Interception& interception,
                          const Vec2& goal_m, double go_round_s) {
  const Vec2 aim = direction_of(goal_m - interception.point_m, Vec2(1, 0));
  const Vec2 approach = direction_of(interception.point_m - robot.position_m, aim);
  // With c as the cosine of the angle between approach and aim, (1 - c) / 2 is 0 behind the ball
  // and 1 in front.
  return interception.time_s + go_round_s * (1 - approach.dot(aim)) / 2;
}

void choose_attacker(const TeamView& view, const Field& field, const Style& style,
                     const Taken& taken, int former_attacker, int barred,
                     RoleAssignment& assignment) {
  double best_s = std::numeric_limits<double>::infinity();
  const BallSamples ball(view.ball);
  for (int i = 0; i < static_cast<int>(view.own.size()); ++i) {
    if (taken[i] || view.own[i].number == barred) continue;
    const Interception interception = intercept(view.own[i], ball);
    // Hysteresis, so that the role does not alternate between two equally near robots.
    const double bonus_s = view.own[i].number == former_attacker ? style.loyalty_s : 0.0;
    const double time_s = time_behind_ball_s(view.own[i], interception,
                                             field.goal_centre_m(Side::kEast), style.go_round_s) -
                          bonus_s;
    if (time_s >= best_s) continue;
    best_s = time_s;
    assignment.attacker = i;
    assignment.interception = interception;
  }
}

// The free robot nearest to `point_m`; -1 if there is none.
int nearest_free(const TeamView& view, const Taken& taken, const Vec2& point_m) {
  int best = -1;
  double best2 = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(view.own.size()); ++i) {
    const double d2 = (view.own[i].position_m - point_m).squaredNorm();
    if (taken[i] || d2 >= best2) continue;
    best2 = d2;
    best = i;
  }
  return best;
}

// The unmarked opponent in the team's own half nearest to the team's own goal, excluding the
// opponent at the ball; -1 if there is no such opponent.
int most_dangerous(const TeamView& view, const Style& style, const Taken& marked,
                   const Vec2& goal_m) {
  int best = -1;
  double best2 = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(view.opponents.size()); ++i) {
    const Vec2& position_m = view.opponents[i].position_m;
    const bool at_ball =
        (position_m - view.ball.position_m).squaredNorm() < square(style.mark_off_ball_m);
    const double d2 = (position_m - goal_m).squaredNorm();
    if (marked[i] || at_ball || position_m.x() > 0 || d2 >= best2) continue;
    best2 = d2;
    best = i;
  }
  return best;
}

void give(RoleAssignment& assignment, Taken& taken, int index, const AssignedRole& role) {
  if (index < 0) return;
  assignment.roles[index] = role;
  taken[index] = true;
}

}  // namespace

Waypoint keeper_position(const Field& field, const Style& style, const TrackedBall& ball) {
  const double line_x = -field.half_length_m() + kRobotRadius_m + style.margin_m;
  const double reach_m = field.half_goal_m() - kRobotRadius_m / 2;
  // At a shot, the keeper stands where the ball's straight path crosses the keeper's line.
  // Otherwise, its offset from the middle is proportional to the sine of the ball's direction.
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
  // more to the sides.
  const double off_m = field.defence_area.depth_m +
                       field.defence_area.straight_m / 2 * std::abs(direction.y()) +
                       kRobotRadius_m + 2 * style.margin_m;
  // The second robot stands on the side towards the middle, as close to the first as obstacle
  // avoidance allows.
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

// Greedy assignment: in order of importance, each role goes to the robot that suits it best.
RoleAssignment assign_roles(const TeamView& view, const Field& field, const Style& style,
                            int former_attacker, int barred) {
  RoleAssignment assignment;
  Taken taken{};
  const Vec2 goal_m = field.goal_centre_m(Side::kWest);
  if (view.own.size() > 1) give(assignment, taken, 0, {Role::kKeeper, -1, 0});
  choose_attacker(view, field, style, taken, former_attacker, barred, assignment);
  give(assignment, taken, assignment.attacker, {Role::kAttacker, -1, 0});
  give(assignment, taken, nearest_free(view, taken, goal_m), {Role::kWall, -1, 0});
  if (view.own.size() > 4)
    give(assignment, taken, nearest_free(view, taken, goal_m), {Role::kWall, -1, 1});
  const Vec2 front_m(0.4 * field.half_length_m(), 0);
  give(assignment, taken, nearest_free(view, taken, front_m), {Role::kSupporter, -1, 0});
  Taken marked{};
  int supporters = 1;
  for (std::size_t left = view.own.size(); left > 0; --left) {
    const int target = most_dangerous(view, style, marked, goal_m);
    const Vec2 near_m = target < 0 ? front_m : view.opponents[target].position_m;
    const int robot = nearest_free(view, taken, near_m);
    if (robot < 0) break;
    if (target >= 0) marked[target] = true;
    give(assignment, taken, robot,
         target < 0 ? AssignedRole{Role::kSupporter, -1, supporters++}
                    : AssignedRole{Role::kMarker, target, 0});
  }
  return assignment;
}

}  // namespace autoref::strategies::basic
