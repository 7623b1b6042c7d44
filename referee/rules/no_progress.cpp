#include "referee/rules/no_progress.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "referee/geometry/restarts.hpp"

namespace autoref::referee {
namespace {

bool is_keepers(const Configuration& c, const Vec2& ball_m) {
  return c.rules.has(RuleId::kKeeperHolding) &&
         std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
           return distance_to_defence_area(c.field, side, ball_m) <= 0;
         });
}

}  // namespace

std::optional<Finding> find_no_progress(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  const Configuration& c = input.configuration;
  if (!play.in_play || !input.ball ||
      !has_passed(play.stuck_since_s, c.rules.stuck_time_s, input.time_s()) ||
      is_keepers(c, input.ball->position_m)) {
    return std::nullopt;
  }
  Finding finding = finding_of(Event::kNoProgress, RuleId::kNoProgress, c.rules);
  finding.value = input.time_s() - play.stuck_since_s;
  finding.position_m = input.ball->position_m;
  finding.restart = {CommandKind::kForceStart, Side::kWest};
  finding.ball_to_m = neutral_position(c.field, c.rules, input.ball->position_m);
  finding.evidence = fmt::format("Since {:.3f} s the ball has stayed within {:.0f} mm.",
                                 play.stuck_since_s, 1e3 * c.rules.stuck_distance_m);
  return finding;
}

}  // namespace autoref::referee
