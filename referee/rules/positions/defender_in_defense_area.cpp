// A robot other than the keeper must not touch the ball in play inside its own defence area. If it
// is entirely inside, the opponents get a penalty kick. If it is partly inside, the Laws of 2014
// give it a yellow card and the opponents an indirect free kick (law 12; 2026, Defender In Defense
// Area).
//
// No rule book makes an exception for a defender pushed there by an opponent.
#include <fmt/format.h>

#include "referee/geometry/area.hpp"
#include "referee/rules/called_touch.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

Finding entirely(const BallTouch& touch, const RefereeInput& input, double out_m) {
  const Configuration& c = input.configuration;
  Finding finding = offence_of(Event::kDefenderInDefenseArea, RuleId::kDefenderInDefenseArea, c,
                               *touch.robot, touch.ended_m);
  finding.value = out_m;
  finding.ball_to_m = c.field.penalty_mark_at(*touch.side);
  finding.evidence = fmt::format(
      "{} touched the ball at {:.3f} s with its hull entirely inside its own area, by {}.",
      text_of(*touch.robot), touch.ended_s, mm_text(-out_m));
  return finding;
}

Finding partly(const BallTouch& touch, const RefereeInput& input, double distance_m) {
  Finding finding =
      offence_of(Event::kDefenderInDefenseAreaPartially, RuleId::kDefenderInDefenseArea,
                 input.configuration, *touch.robot, touch.ended_m);
  finding.value = distance_m;
  finding.evidence =
      fmt::format("{} touched the ball at {:.3f} s with its hull reaching {} into its own area.",
                  text_of(*touch.robot), touch.ended_s, mm_text(-distance_m));
  return finding;
}

std::optional<Finding> check_defender(RefereeState& /*state*/, const BallTouch& touch,
                                      const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const int keeper = input.requests[*touch.side].keeper;
  if (keeper < 0 || touch.robot->number == keeper) return std::nullopt;
  const double distance_m = hull_to_area_m(c.field, *touch.side, *touch.toucher);
  if (!(distance_m < 0)) return std::nullopt;
  const double out_m = hull_out_of_area_m(c.field, *touch.side, *touch.toucher);
  const bool is_entirely = out_m < 0;
  if (!is_entirely && c.rules.edition == Edition::kRules2026) return std::nullopt;
  Finding finding = is_entirely ? entirely(touch, input, out_m) : partly(touch, input, distance_m);
  finding.threshold = 0;
  finding.unit = "m";
  finding.details.robot_m = touch.toucher->position_m;
  finding.details.ball_m = touch.ended_m;
  return finding;
}

std::optional<Finding> find_defender_in_defense_area(RefereeState& state,
                                                     const RefereeInput& input) {
  return find_in_touches(state, input, check_defender);
}

}  // namespace

constinit const Rule kDefenderInDefenseAreaRule{{State::kRun}, find_defender_in_defense_area};

}  // namespace autoref::referee
