#include "strategies/tactics/defend.hpp"

#include <algorithm>
#include <array>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

constexpr int kSteps = 5;  // to the area's rim; each halves what is left, or better

// On the ray from the goal's middle, so far outside the own area.
Vec2 on_rim(const Field& field, const Vec2& way, double off_m) {
  const Vec2 goal_m = field.goal_centre_m(Side::kWest);
  Vec2 p = goal_m + way * (field.defence_area.depth_m + off_m);
  for (int i = 0; i < kSteps; ++i)
    p += way * (off_m - distance_to_defence_area(field, Side::kWest, p));
  return p;
}

}  // namespace

Waypoint wall_place(const Outlook& outlook, int order, int count) {
  const Field& field = outlook.field();
  const Vec2& ball_m = outlook.place_m();
  const Vec2 goal_m = field.goal_centre_m(Side::kWest);
  Vec2 way = direction_of(ball_m - goal_m, Vec2(1, 0));
  if (way.x() < 0.1) way = direction_of(Vec2(0.1, way.y()), Vec2(1, 0));
  const double aside_m =
      (2 * kRobotRadius_m + outlook.style().wall_gap_m) * (order - (count - 1) / 2.0);
  const Vec2 middle_m = on_rim(field, way, (kRobotRadius_m + outlook.style().wall_off_area_m));
  Vec2 place_m = middle_m + left_of(way) * aside_m;
  const double missing_m = (kRobotRadius_m + outlook.style().wall_off_area_m) -
                           distance_to_defence_area(field, Side::kWest, place_m);
  if (missing_m > 0) place_m += way * missing_m;
  return facing_ball(outlook, place_m);
}

Waypoint mark_place(const Outlook& outlook, int opponent) {
  const TrackedRobot& target = outlook.now().opponents[static_cast<std::size_t>(opponent)];
  const Vec2 goal_m = outlook.field().goal_centre_m(Side::kWest);
  const Vec2 to_goal = direction_of(goal_m - target.position_m, Vec2(-1, 0));
  const Vec2 to_ball = direction_of(outlook.place_m() - target.position_m, Vec2(-1, 0));
  const Vec2 way = direction_of(
      to_goal * (1 - outlook.style().mark_ball_side) + to_ball * outlook.style().mark_ball_side,
      to_goal);
  return facing_ball(outlook, target.position_m + way * outlook.style().mark_m);
}

boost::container::static_vector<int, kMaxRobots> dangerous_opponents(const Outlook& outlook) {
  const TrackedRobots& all = outlook.now().opponents;
  const Vec2 goal_m = outlook.field().goal_centre_m(Side::kWest);
  std::array<double, kMaxRobots> distance_m{};
  boost::container::static_vector<int, kMaxRobots> order;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const Vec2& p = all[static_cast<std::size_t>(i)].position_m;
    distance_m[static_cast<std::size_t>(i)] = (p - goal_m).norm();
    const bool at_ball = i == outlook.their_fastest() && outlook.now().play == Play::kRunning;
    if (at_ball || (p - outlook.place_m()).norm() < outlook.style().mark_off_ball_m ||
        p.x() > outlook.style().harmless_m)
      continue;
    order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return distance_m[static_cast<std::size_t>(a)] < distance_m[static_cast<std::size_t>(b)];
  });
  return order;
}

}  // namespace autoref::strategies
