// If the ball makes no progress for 10 s (Division A: 5 s) although both teams may play it, the
// game continues with a force start (2026, No Progress In Game). A ball in a defence area is the
// keeper's responsibility (rule keeper_held_ball).
#include <fmt/format.h>

#include "referee/geometry/restarts.hpp"
#include "referee/rules/lack_of_progress.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> find_no_progress_in_game(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const std::optional<double> since_s = without_progress_since_s(state, input);
  if (!since_s) return std::nullopt;
  Finding finding = finding_of(Event::kNoProgressInGame, RuleId::kNoProgressInGame, c.rules);
  finding.value = input.time_s() - *since_s;
  finding.position_m = input.ball->position_m;
  finding.ball_to_m = neutral_position(c.field, c.rules, input.ball->position_m);
  finding.evidence = fmt::format("The ball has moved less than {1:.0f} mm since {0:.3f} s.",
                                 *since_s, 1e3 * c.rules.stuck_distance_m);
  return finding;
}

}  // namespace

constinit const Rule kNoProgressInGameRule{{State::kRun}, find_no_progress_in_game};

}  // namespace autoref::referee
