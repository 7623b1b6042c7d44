// The rules on a ball that makes no progress for some time although both teams may play it.
#include <fmt/format.h>
#include <algorithm>
#include <optional>

#include "referee/geometry/restarts.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

// The time since which the ball has moved less than `RuleBook::stuck_distance_m`, if that is at
// least `RuleBook::stuck_time_s` ago. Time in which the keeper may hold the ball in its defence
// area does not count here, since that time has its own limit (rule keeper_held_ball).
std::optional<double> without_progress_since_s(const RefereeState& state,
                                               const RefereeInput& input) {
  const PlayState& play = state.play;
  if (!play.in_play || !input.ball) return std::nullopt;
  const double kept_s = state.watch.keeper_held_ball.last_s.value_or(play.stuck_since_s);
  const double since_s = std::max(play.stuck_since_s, kept_s);
  const bool is_long = has_passed(since_s, input.configuration.rules.stuck_time_s, input.time_s());
  return is_long ? std::optional(since_s) : std::nullopt;
}

// Deviation D11: a ball in play that has moved less than 250 mm in 10 s is stuck. Play continues
// with a force start from a neutral position (2016; Laws 2014, law 9). A ball that a keeper holds
// in its own area is not stuck: the keeper has 15 s to release it (rule keeper_held_ball).
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

// If the ball makes no progress for 10 s (Division A: 5 s) although both teams may play it, the
// game continues with a force start (2026, No Progress In Game). A ball in a defence area is the
// keeper's responsibility (rule keeper_held_ball).
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

constinit const Rule kStuckBallRule{{State::kRun}, find_stuck_ball};
constinit const Rule kNoProgressInGameRule{{State::kRun}, find_no_progress_in_game};

}  // namespace autoref::referee
