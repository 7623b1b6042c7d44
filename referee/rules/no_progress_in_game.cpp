// If the ball makes no progress for 10 s (Division A: 5 s) although both teams may play it, the
// game continues with a force start (2026, Lack Of Progress). A ball at rest in a defence area is
// the keeper's responsibility (rule keeper_held_ball).
#include <fmt/format.h>

#include <algorithm>

#include "referee/geometry/restarts.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

bool is_keepers(const Configuration& c, const Vec2& ball_m) {
  return c.rules.has(RuleId::kKeeperHeldBall) &&
         std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
           return distance_to_defence_area(c.field, side, ball_m) <= 0;
         });
}

std::optional<Finding> find_no_progress_in_game(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  const Configuration& c = input.configuration;
  if (!play.in_play || !input.ball ||
      !has_passed(play.stuck_since_s, c.rules.stuck_time_s, input.time_s()) ||
      is_keepers(c, input.ball->position_m)) {
    return std::nullopt;
  }
  Finding finding = finding_of(Event::kNoProgressInGame, RuleId::kNoProgressInGame, c.rules);
  finding.value = input.time_s() - play.stuck_since_s;
  finding.position_m = input.ball->position_m;
  finding.ball_to_m = neutral_position(c.field, c.rules, input.ball->position_m);
  finding.evidence = fmt::format("The ball has moved less than {1:.0f} mm since {0:.3f} s.",
                                 play.stuck_since_s, 1e3 * c.rules.stuck_distance_m);
  return finding;
}

}  // namespace

constinit const Rule kNoProgressInGameRule{{State::kRun}, find_no_progress_in_game};

}  // namespace autoref::referee
