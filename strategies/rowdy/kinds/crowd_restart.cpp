#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kFromBall_m = 300_mm;  // to the robot's centre

std::optional<ActiveFoul> find_chance(const Scene& scene) {
  if (!is_opponents_restart(scene)) return std::nullopt;
  return foul_by(nearest_mate(scene, scene.now.ball.position_m, scene.field.length_m),
                 scene.now.ball.position_m);
}

bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = scene.now.ball.position_m;
  const Vec2 back = direction_of(scene.field.goal_centre_m(Side::kWest) - ball_m, Vec2(-1, 0));
  output.command(foul.robot) =
      go_to(scene, *find(scene.now.own, foul.robot), ball_m + back * kFromBall_m);
  return is_opponents_restart(scene);
}

}  // namespace

const FoulBehaviour kCrowdRestart = {"crowd_restart",
                                     "Stands within 500 mm of the ball at the opponents' restarts.",
                                     0.15,
                                     12,
                                     find_chance,
                                     go_on};

}  // namespace autoref::strategies::rowdy
