#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kReach_m = 3.0;  // largest distance of the robot from the goal's centre
constexpr double kFromArea_m = 80_mm + kRobotRadius_m;
// A robot closer to the ball would push it while it is placed.
constexpr double kFromBall_m = 700_mm;
constexpr int kSteps = 6;

bool is_waiting(const RowdyView& view) {
  return view.now.play == Play::kStop || is_own_restart(view) || is_opponents_restart(view);
}

Vec2 ball_target_m(const RowdyView& view) {
  return view.now.placement_m.value_or(view.now.ball.position_m);
}

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_waiting(view) || ball_target_m(view).x() < 0) return std::nullopt;
  const Vec2 goal_m = view.field.goal_centre_m(Side::kEast);
  const TrackedRobot* mate = nearest_mate(view, goal_m, kReach_m);
  return foul_by(mate, mate != nullptr ? mate->position_m : goal_m);
}

// The position near the area's edge on the ray from the goal through `from_m`, found by sphere
// tracing: each step moves along the ray by the distance still missing.
Vec2 position_at_rim(const RowdyView& view, const Vec2& from_m) {
  const Vec2 goal_m = view.field.goal_centre_m(Side::kEast);
  const Vec2 direction = direction_of(from_m - goal_m, Vec2(-1, 0));
  Vec2 position_m = goal_m + direction * view.field.defence_area.depth_m;
  for (int i = 0; i < kSteps; ++i) {
    position_m +=
        direction * (kFromArea_m - distance_to_defence_area(view.field, Side::kEast, position_m));
  }
  return position_m;
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2 position_m = position_at_rim(view, foul.from_m);
  output.command(foul.robot) = go_to(view, *find(view.now.own, foul.robot), position_m);
  return is_waiting(view) && (position_m - ball_target_m(view)).norm() > kFromBall_m;
}

}  // namespace

const FoulBehaviour kNearArea = {
    "near_area", "Waits within 200 mm of the opponents' area at restarts.", 0.1, 25, find_chance,
    go_on};

}  // namespace autoref::strategies::rowdy
