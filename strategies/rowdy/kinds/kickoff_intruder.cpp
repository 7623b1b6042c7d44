#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kBeyond_m = 700_mm;  // beyond the halfway line
constexpr double kBesideShare = 0.5;  // fraction of half the field's width

bool is_kickoff(const Scene& scene) {
  return scene.now.play == Play::kPrepareKickoff || scene.now.play == Play::kKickoff;
}

Vec2 position_m(const Scene& scene) {
  return {kBeyond_m, kBesideShare * scene.field.half_width_m()};
}

std::optional<ActiveFoul> find_chance(const Scene& scene) {
  if (!is_kickoff(scene)) return std::nullopt;
  return foul_by(nearest_mate(scene, position_m(scene), scene.field.length_m),
                 scene.now.ball.position_m);
}

bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  output.command(foul.robot) = go_to(scene, *find(scene.now.own, foul.robot), position_m(scene));
  return is_kickoff(scene);
}

}  // namespace

const FoulBehaviour kKickoffIntruder = {"kickoff_intruder",
                                        "Puts a robot in the opponents' half at a kick-off.",
                                        0.3,
                                        25,
                                        find_chance,
                                        go_on};

}  // namespace autoref::strategies::rowdy
