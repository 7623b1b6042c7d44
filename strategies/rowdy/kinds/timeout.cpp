#include "strategies/rowdy/kinds.hpp"

namespace autoref::strategies::rowdy {
namespace {

std::optional<Deed> find_chance(const Scene& scene) {
  if (scene.now.play != Play::kStop) return std::nullopt;
  return Deed{};
}

bool go_on(const Scene& scene, Deed& /*deed*/, Will& will) {
  will.requests.timeout = true;
  return scene.now.play == Play::kStop;
}

}  // namespace

const Mischief kTimeout = {"timeout", "Asks for a timeout.", 0.005, 1, find_chance, go_on};

}  // namespace autoref::strategies::rowdy
