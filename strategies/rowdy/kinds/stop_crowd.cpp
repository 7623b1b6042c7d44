#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kFromBall_m = 350_mm;  // to the robot's centre

Vec2 ball_target_m(const Scene& scene) {
  return scene.now.placement_m.value_or(scene.now.ball.position_m);
}

std::optional<ActiveFoul> find_chance(const Scene& scene) {
  if (scene.now.play != Play::kStop) return std::nullopt;
  return foul_by(nearest_mate(scene, ball_target_m(scene), scene.field.length_m),
                 ball_target_m(scene));
}

bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  const Vec2 ball_m = ball_target_m(scene);
  const Vec2 back = direction_of(scene.field.goal_centre_m(Side::kWest) - ball_m, Vec2(-1, 0));
  output.command(foul.robot) =
      go_to(scene, *find(scene.now.own, foul.robot), ball_m + back * kFromBall_m);
  return scene.now.play == Play::kStop;
}

}  // namespace

const FoulBehaviour kStopCrowd = {
    "stop_crowd", "Stands within 500 mm of the ball while play is stopped.", 0.1, 6, find_chance,
    go_on};

}  // namespace autoref::strategies::rowdy
