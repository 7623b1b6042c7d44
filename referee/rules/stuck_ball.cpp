// Deviation D11: a ball in play that has moved less than 250 mm in 10 s is stuck. Play continues
// with a force start from a neutral position (2016; Laws 2014, law 9). A ball that a keeper holds
// in its own area is not stuck: the keeper has 15 s to release it (rule keeper_held_ball).
#include <fmt/format.h>

#include "referee/geometry/restarts.hpp"
#include "referee/rules/lack_of_progress.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> find_stuck_ball(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  const Configuration& c = input.configuration;
  const std::optional<double> since_s = without_progress_since_s(state, input);
  if (!since_s) return std::nullopt;
  Finding finding = finding_of(Event::kStuckBall, RuleId::kStuckBall, c.rules);
  finding.value = (input.ball->position_m - play.stuck_at_m).norm();
  finding.position_m = input.ball->position_m;
  finding.details.waited_s = input.time_s() - *since_s;
  finding.ball_to_m = neutral_position(c.field, c.rules, input.ball->position_m);
  finding.evidence = fmt::format("The ball has moved less than {1:.0f} mm since {0:.3f} s.",
                                 *since_s, 1e3 * c.rules.stuck_distance_m);
  return finding;
}

}  // namespace

constinit const Rule kStuckBallRule{{State::kRun}, find_stuck_ball};

}  // namespace autoref::referee
