#include "strategies/rowdy/foul_behaviours.hpp"

#include "strategies/skills/openings.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kShot_mps = 6.0;

std::optional<ActiveFoul> find_chance(const Scene& scene) {
  if (!scene.now.ours || scene.now.play != Play::kIndirectFree) return std::nullopt;
  return foul_by(nearest_mate(scene, scene.now.ball.position_m, scene.field.length_m),
                 scene.now.ball.position_m);
}

bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = scene.now.ball.position_m;
  const Vec2 target_m = best_shot(scene.field, ball_m, scene.now.opponents).target_m;
  clear_lane(scene, foul.robot, ball_m, target_m, output.commands);
  output.command(foul.robot) =
      kick_at(scene, *find(scene.now.own, foul.robot), target_m, kShot_mps);
  return scene.now.play == Play::kIndirectFree;
}

}  // namespace

const FoulBehaviour kIndirectShot = {"indirect_shot",
                                     "Shoots straight at the goal from an indirect free kick.",
                                     0.3,
                                     10,
                                     find_chance,
                                     go_on};

}  // namespace autoref::strategies::rowdy
