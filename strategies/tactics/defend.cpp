#include "strategies/tactics/defend.hpp"

#include <algorithm>
#include <array>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

constexpr int kHalvings = 12;  // of a quarter turn: to 0.4 mrad
constexpr int kSteps = 5;      // each at least halves the distance to the area's edge

// The point at distance `off_m` outside the team's own area on the ray from a point in the goal.
// Found by sphere tracing: each step moves along the ray by the distance still missing.
Vec2 on_rim(const Field& field, const Vec2& goal_m, const Vec2& direction, double off_m) {
  Vec2 p = goal_m + direction * (field.defence_area.depth_m + off_m);
  for (int i = 0; i < kSteps; ++i)
    p += direction * (off_m - distance_to_defence_area(field, Side::kWest, p));
  return p;
}

}  // namespace

Waypoint wall_position(const PredictedState& predicted, int order, int count) {
  const Field& field = predicted.field();
  const Vec2& ball_m = predicted.threat_m();
  const double near = std::clamp(ball_m.y() / field.half_goal_m(), -1.0, 1.0);
  const Vec2 goal_m =
      field.goal_centre_m(Side::kWest) + Vec2(0, near * predicted.style().wall_near_post_m);
  Vec2 direction = direction_of(ball_m - goal_m, Vec2(1, 0));
  if (direction.x() < 0.1) direction = direction_of(Vec2(0.1, direction.y()), Vec2(1, 0));
  const double aside_m =
      (2 * kRobotRadius_m + predicted.style().wall_gap_m) * (order - (count - 1) / 2.0);
  const Vec2 middle_m =
      on_rim(field, goal_m, direction, (kRobotRadius_m + predicted.style().wall_off_area_m));
  Vec2 position_m = middle_m + left_of(direction) * aside_m;
  const double missing_m = (kRobotRadius_m + predicted.style().wall_off_area_m) -
                           distance_to_defence_area(field, Side::kWest, position_m);
  if (missing_m > 0) position_m += direction * missing_m;
  return facing_ball(predicted, position_m);
}

Waypoint split_wall_position(const PredictedState& predicted, int order) {
  const Field& field = predicted.field();
  const Vec2& ball_m = predicted.position_m();
  const Vec2 to_goal = direction_of(field.goal_centre_m(Side::kWest) - ball_m, Vec2(-1, 0));
  const double radius_m = predicted.room_at_ball_m() + kRobotRadius_m + kNarrowMargin_m;
  const auto at = [&](double angle_rad) {
    return Vec2(ball_m + radius_m * to_world(to_goal, heading_of(angle_rad)));
  };
  const double side = order % 2 == 0 ? 1 : -1;
  double inside_rad = 0, outside_rad = kPi / 2;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_rad = (inside_rad + outside_rad) / 2;
    const bool is_clear = distance_to_defence_area(field, Side::kWest, at(side * middle_rad)) >=
                          kRobotRadius_m + kNarrowMargin_m;
    (is_clear ? outside_rad : inside_rad) = middle_rad;
  }
  const double next_rad = (2 * kRobotRadius_m + predicted.style().wall_gap_m) / radius_m;
  const int nearer = order / 2;  // robots of this side that stand nearer to the shot
  return facing_ball(predicted, at(side * (outside_rad + nearer * next_rad)));
}

Waypoint mark_position(const PredictedState& predicted, int opponent) {
  const TrackedRobot& target = predicted.now().opponents[static_cast<std::size_t>(opponent)];
  const Vec2 goal_m = predicted.field().goal_centre_m(Side::kWest);
  const Vec2 to_goal = direction_of(goal_m - target.position_m, Vec2(-1, 0));
  const Vec2 to_ball = direction_of(predicted.position_m() - target.position_m, Vec2(-1, 0));
  const Vec2 direction = direction_of(
      to_goal * (1 - predicted.style().mark_ball_side) + to_ball * predicted.style().mark_ball_side,
      to_goal);
  return facing_ball(predicted, target.position_m + direction * predicted.style().mark_m);
}

boost::container::static_vector<int, kMaxRobots> dangerous_opponents(
    const PredictedState& predicted) {
  const TrackedRobots& all = predicted.now().opponents;
  const Vec2 goal_m = predicted.field().goal_centre_m(Side::kWest);
  std::array<double, kMaxRobots> distance_m{};
  boost::container::static_vector<int, kMaxRobots> order;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const Vec2& p = all[static_cast<std::size_t>(i)].position_m;
    distance_m[static_cast<std::size_t>(i)] = (p - goal_m).norm();
    const bool at_ball = i == predicted.their_fastest() && predicted.now().play == Play::kRunning;
    if (at_ball || (p - predicted.position_m()).norm() < predicted.style().mark_off_ball_m ||
        p.x() > predicted.style().harmless_m)
      continue;
    order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return distance_m[static_cast<std::size_t>(a)] < distance_m[static_cast<std::size_t>(b)];
  });
  return order;
}

}  // namespace autoref::strategies
