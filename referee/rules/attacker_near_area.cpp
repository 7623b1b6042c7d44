#include "referee/rules/attacker_near_area.hpp"

#include <fmt/format.h>

#include "referee/geometry/area.hpp"
#include "referee/geometry/restarts.hpp"

namespace autoref::referee {
namespace {

struct Offence {
  RobotId robot;
  Vec2 position_m{0, 0};
  double distance_m = 0;
};

// The robot of `side` nearest to the opponents' area, if it is too near.
std::optional<Offence> worst_of(Side side, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  std::optional<Offence> worst;
  double nearest_m = c.rules.attacker_to_area_m;
  for (const RobotObservation& robot : input.frame.robots[side]) {
    const double distance_m = hull_to_area_m(c.field, opponent_of(side), robot);
    if (!(distance_m < nearest_m)) continue;
    nearest_m = distance_m;
    worst = Offence{{side, robot.number}, robot.position_m, distance_m};
  }
  return worst;
}

}  // namespace

std::optional<Finding> find_attacker_near_area(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  // A penalty kick is taken from where nobody else may be.
  if (!c.rules.fouls_stop_play || state.play.is_penalty()) return std::nullopt;
  if (!state.play.entered_now || !state.play.kicker) return std::nullopt;
  std::optional<Offence> offence = worst_of(*state.play.kicker, input);
  if (!offence) offence = worst_of(opponent_of(*state.play.kicker), input);
  if (!offence) return std::nullopt;
  Finding finding = offence_of(Event::kAttackerNearArea, RuleId::kAttackerNearArea, c,
                               offence->robot, offence->position_m);
  finding.value = offence->distance_m;
  finding.evidence = fmt::format(
      "When the ball entered play, the hull of {} was {:.0f} mm from the opponents' area.",
      text_of(offence->robot), 1e3 * offence->distance_m);
  return finding;
}

}  // namespace autoref::referee
