#include "referee/rules/attacker_in_area.hpp"

#include <fmt/format.h>

#include "referee/geometry/area.hpp"
#include "referee/rules/area_touches.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> check(const BallTouch& touch, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const double distance_m = hull_to_area_m(c.field, opponent_of(*touch.side), *touch.toucher);
  if (!(distance_m < 0)) return std::nullopt;
  Finding finding =
      offence_of(Event::kAttackerInArea, RuleId::kAttackerInArea, c, *touch.robot, touch.ended_m);
  finding.value = distance_m;
  finding.threshold = 0;
  finding.unit = "m";
  finding.evidence = fmt::format(
      "{} touched the ball at {:.3f} s, {:.0f} mm inside the area of {}.", text_of(*touch.robot),
      touch.ended_s, -1e3 * distance_m, name_of(opponent_of(*touch.side)));
  return finding;
}

}  // namespace

std::optional<Finding> find_attacker_in_area(RefereeState& state, const RefereeInput& input) {
  return find_in_touches(state.play, input, check);
}

}  // namespace autoref::referee
