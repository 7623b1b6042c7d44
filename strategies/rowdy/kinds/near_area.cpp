#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kReach_m = 3.0;  // from the goal's centre
constexpr double kFromArea_m = 80_mm + kRobotRadius_m;
constexpr double kFromBall_m = 700_mm;  // a closer robot would push a ball being placed
constexpr int kSteps = 6;

bool is_waiting(const Scene& scene) {
  return scene.now.play == Play::kStop || is_own_restart(scene) || is_opponents_restart(scene);
}

Vec2 ball_target_m(const Scene& scene) {
  return scene.now.placement_m.value_or(scene.now.ball.position_m);
}

std::optional<ActiveFoul> find_chance(const Scene& scene) {
  if (!is_waiting(scene) || ball_target_m(scene).x() < 0) return std::nullopt;
  const Vec2 goal_m = scene.field.goal_centre_m(Side::kEast);
  const TrackedRobot* mate = nearest_mate(scene, goal_m, kReach_m);
  return foul_by(mate, mate != nullptr ? mate->position_m : goal_m);
}

// The position near the area's edge on the ray from the goal through `from_m`, found by sphere
// tracing: each step moves along the ray by the distance still missing.
Vec2 position_at_rim(const Scene& scene, const Vec2& from_m) {
  const Vec2 goal_m = scene.field.goal_centre_m(Side::kEast);
  const Vec2 direction = direction_of(from_m - goal_m, Vec2(-1, 0));
  Vec2 position_m = goal_m + direction * scene.field.defence_area.depth_m;
  for (int i = 0; i < kSteps; ++i) {
    position_m +=
        direction * (kFromArea_m - distance_to_defence_area(scene.field, Side::kEast, position_m));
  }
  return position_m;
}

bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  const Vec2 position_m = position_at_rim(scene, foul.from_m);
  output.command(foul.robot) = go_to(scene, *find(scene.now.own, foul.robot), position_m);
  return is_waiting(scene) && (position_m - ball_target_m(scene)).norm() > kFromBall_m;
}

}  // namespace

const FoulBehaviour kNearArea = {
    "near_area", "Waits within 200 mm of the opponents' area at restarts.", 0.1, 25, find_chance,
    go_on};

}  // namespace autoref::strategies::rowdy
