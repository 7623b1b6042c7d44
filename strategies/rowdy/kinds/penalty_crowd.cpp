#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kBeside_m = 500_mm;  // beside the mark

bool is_penalty(const Scene& scene) {
  return scene.now.play == Play::kPreparePenalty || scene.now.play == Play::kPenalty;
}

Vec2 mark_m(const Scene& scene) {
  return scene.now.placement_m.value_or(scene.now.ball.position_m);
}

// Uses a robot other than the kicker.
std::optional<ActiveFoul> find_chance(const Scene& scene) {
  if (!is_penalty(scene)) return std::nullopt;
  const TrackedRobot* kicker =
      scene.now.ours ? nearest_mate(scene, mark_m(scene), scene.field.length_m) : nullptr;
  for (const TrackedRobot& mate : scene.now.own) {
    if (mate.number != scene.keeper && &mate != kicker) return foul_by(&mate, mark_m(scene));
  }
  return std::nullopt;
}

bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  output.command(foul.robot) =
      go_to(scene, *find(scene.now.own, foul.robot), foul.from_m + Vec2(0, kBeside_m));
  return is_penalty(scene);
}

}  // namespace

const FoulBehaviour kPenaltyCrowd = {"penalty_crowd",
                                     "Puts a robot beside the mark when a penalty kick is taken.",
                                     0.4,
                                     25,
                                     find_chance,
                                     go_on};

}  // namespace autoref::strategies::rowdy
