#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

std::optional<ActiveFoul> find_chance(const Scene& scene) {
  if (!is_own_restart(scene)) return std::nullopt;
  return ActiveFoul{};
}

bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  hold_back(scene, foul.robot, scene.now.ball.position_m, 2 * scene.field.length_m,
            output.commands);
  return is_own_restart(scene);
}

}  // namespace

const FoulBehaviour kDelay = {"delay", "Does not take its restart in time.", 0.05, 15, find_chance,
                              go_on};

}  // namespace autoref::strategies::rowdy
