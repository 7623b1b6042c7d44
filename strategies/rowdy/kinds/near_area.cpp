#include "strategies/rowdy/kinds.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kReach_m = 3.0;  // from the goal's middle
constexpr double kFromArea_m = 80_mm + kRobotRadius_m;
constexpr int kSteps = 6;

bool is_waiting(const Scene& scene) {
  return scene.now.play == Play::kStop || is_own_restart(scene) || is_opponents_restart(scene);
}

std::optional<Deed> find_chance(const Scene& scene) {
  const Vec2 ball_m = scene.now.placement_m.value_or(scene.now.ball.position_m);
  if (!is_waiting(scene) || ball_m.x() < 0) return std::nullopt;
  const Vec2 goal_m = scene.field.goal_centre_m(Side::kEast);
  const TrackedRobot* mate = nearest_mate(scene, goal_m, kReach_m);
  return deed_of(mate, mate != nullptr ? mate->position_m : goal_m);
}

// The place at the area's rim in that direction from the goal, stepping along it.
Vec2 place_at_rim(const Scene& scene, const Vec2& from_m) {
  const Vec2 goal_m = scene.field.goal_centre_m(Side::kEast);
  const Vec2 way = direction_of(from_m - goal_m, Vec2(-1, 0));
  Vec2 place_m = goal_m + way * scene.field.defence_area.depth_m;
  for (int i = 0; i < kSteps; ++i) {
    place_m += way * (kFromArea_m - distance_to_defence_area(scene.field, Side::kEast, place_m));
  }
  return place_m;
}

bool go_on(const Scene& scene, Deed& deed, Will& will) {
  will.order(deed.robot) =
      go_to(scene, *find(scene.now.own, deed.robot), place_at_rim(scene, deed.from_m));
  return is_waiting(scene);
}

}  // namespace

const Mischief kNearArea = {"near_area", "Waits within 200 mm of the opponents' area at restarts.",
                            0.1,         25,
                            find_chance, go_on};

}  // namespace autoref::strategies::rowdy
