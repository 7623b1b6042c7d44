// A robot must not touch the ball in play while it is partly or entirely inside the opponents'
// defence area (2026, Attacker In Defense Area).
#include <fmt/format.h>

#include "referee/geometry/area.hpp"
#include "referee/rules/area_touches.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> check(const BallTouch& touch, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const double distance_m = hull_to_area_m(c.field, opponent_of(*touch.side), *touch.toucher);
  if (!(distance_m < 0)) return std::nullopt;
  Finding finding =
      offence_of(Event::kAttackerTouchedBallInDefenseArea,
                 RuleId::kAttackerTouchedBallInDefenseArea, c, *touch.robot, touch.ended_m);
  finding.value = distance_m;
  finding.threshold = 0;
  finding.unit = "m";
  finding.evidence = fmt::format(
      "{} touched the ball at {:.3f} s, {:.0f} mm inside the area of {}.", text_of(*touch.robot),
      touch.ended_s, -1e3 * distance_m, name_of(opponent_of(*touch.side)));
  return finding;
}

std::optional<Finding> find_attacker_touched_ball_in_defense_area(RefereeState& state,
                                                                  const RefereeInput& input) {
  return find_in_touches(state.play, input, check);
}

}  // namespace

constinit const Rule kAttackerTouchedBallInDefenseAreaRule{
    {State::kRun}, find_attacker_touched_ball_in_defense_area};

}  // namespace autoref::referee
