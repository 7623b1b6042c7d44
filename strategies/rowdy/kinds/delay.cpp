#include "strategies/rowdy/kinds.hpp"

namespace autoref::strategies::rowdy {
namespace {

std::optional<Deed> find_chance(const Scene& scene) {
  if (!is_own_restart(scene)) return std::nullopt;
  return Deed{};
}

bool go_on(const Scene& scene, Deed& deed, Will& will) {
  hold_back(scene, deed.robot, scene.now.ball.position_m, 2 * scene.field.length_m, will.orders);
  return is_own_restart(scene);
}

}  // namespace

const Mischief kDelay = {"delay", "Lets its restart run out.", 0.05, 15, find_chance, go_on};

}  // namespace autoref::strategies::rowdy
