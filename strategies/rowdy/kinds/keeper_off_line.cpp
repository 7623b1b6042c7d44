#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kBeforeLine_m = 350_mm;

bool is_their_penalty(const Scene& scene) {
  return !scene.now.ours &&
         (scene.now.play == Play::kPreparePenalty || scene.now.play == Play::kPenalty);
}

std::optional<ActiveFoul> find_chance(const Scene& scene) {
  if (!is_their_penalty(scene)) return std::nullopt;
  return foul_by(find(scene.now.own, scene.keeper), scene.now.ball.position_m);
}

bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  const Vec2 position_m = scene.field.goal_centre_m(Side::kWest) + Vec2(kBeforeLine_m, 0);
  output.command(foul.robot) = go_to(scene, *find(scene.now.own, foul.robot), position_m);
  return is_their_penalty(scene);
}

}  // namespace

const FoulBehaviour kKeeperOffLine = {"keeper_off_line",
                                      "The keeper leaves its line before a penalty kick is taken.",
                                      0.4,
                                      25,
                                      find_chance,
                                      go_on};

}  // namespace autoref::strategies::rowdy
