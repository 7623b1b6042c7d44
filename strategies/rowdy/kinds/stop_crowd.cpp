#include "strategies/rowdy/kinds.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kFromBall_m = 350_mm;  // to the robot's centre

Vec2 ball_place_m(const Scene& scene) {
  return scene.now.placement_m.value_or(scene.now.ball.position_m);
}

std::optional<Deed> find_chance(const Scene& scene) {
  if (scene.now.play != Play::kStop) return std::nullopt;
  return deed_of(nearest_mate(scene, ball_place_m(scene), scene.field.length_m),
                 ball_place_m(scene));
}

bool go_on(const Scene& scene, Deed& deed, Will& will) {
  const Vec2 ball_m = ball_place_m(scene);
  const Vec2 back = direction_of(scene.field.goal_centre_m(Side::kWest) - ball_m, Vec2(-1, 0));
  will.order(deed.robot) =
      go_to(scene, *find(scene.now.own, deed.robot), ball_m + back * kFromBall_m);
  return scene.now.play == Play::kStop;
}

}  // namespace

const Mischief kStopCrowd = {
    "stop_crowd", "Stands nearer than 500 mm to the ball while play is stopped.",
    0.1,          6,
    find_chance,  go_on};

}  // namespace autoref::strategies::rowdy
