// Deviation D10: if the ball of a restart is not in play 10 s after the signal, play continues with
// a force start (Laws 2014, laws 8 and 9; 2016). In 2026 the opponents get a free kick from the
// ball's position; in Division A, free kicks must be taken within 5 s. For penalty kicks, see rule
// penalty_kick_failed.
#include <fmt/format.h>

#include <algorithm>

#include "referee/geometry/restarts.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

double limit_s(const PlayState& play, const RuleBook& rules) {
  const bool is_free_kick = play.began_with.kind == CommandKind::kDirectFree ||
                            play.began_with.kind == CommandKind::kIndirectFree;
  return is_free_kick ? rules.free_kick_timeout_s : rules.restart_timeout_s;
}

// The time for the kick restarts when an opponent is called for standing too near (2026).
double waited_since_s(const RefereeState& state) {
  const double began_s = state.play.began_s;
  return std::max(began_s, state.watch.defender_too_close_to_kick_point.called_s.value_or(began_s));
}

// Sets the next restart: a force start, or the opponents' free kick.
void go_on(Finding& finding, const PlayState& play, const Configuration& c) {
  const Vec2 ball_m = play.ball_from_m.value_or(Vec2(0, 0));
  if (c.rules.untaken_goes_to_opponents && play.kicker) {
    const Side opponent = opponent_of(*play.kicker);
    finding.offender = play.kicker;
    finding.restart = {CommandKind::kDirectFree, opponent};
    finding.ball_to_m = free_kick_position(c.field, c.rules, opponent, ball_m);
    return;
  }
  finding.restart = {CommandKind::kForceStart, Side::kWest};
  // The penalty mark may be inside the defence area.
  finding.ball_to_m = play.is_penalty() ? neutral_position(c.field, c.rules, ball_m) : ball_m;
}

std::optional<Finding> find_restart_not_taken(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  const Configuration& c = input.configuration;
  if (play.in_play || (play.is_penalty() && c.rules.has(RuleId::kPenaltyKickFailed))) {
    return std::nullopt;
  }
  const double since_s = waited_since_s(state);
  if (!has_passed(since_s, limit_s(play, c.rules), input.time_s())) return std::nullopt;
  Finding finding = finding_of(Event::kRestartNotTaken, RuleId::kRestartNotTaken, c.rules);
  finding.value = input.time_s() - since_s;
  finding.threshold = limit_s(play, c.rules);
  finding.position_m = play.ball_from_m;
  go_on(finding, play, c);
  finding.evidence =
      fmt::format("{} was signalled at {:.3f} s, but the ball has moved less than {:.0f} mm{}.",
                  name_of(play.began_with), play.began_s, 1e3 * c.rules.in_play_m,
                  since_s > play.began_s ? fmt::format(" since {:.3f} s", since_s) : "");
  return finding;
}

}  // namespace

constinit const Rule kRestartNotTakenRule{{State::kRun}, find_restart_not_taken};

}  // namespace autoref::referee
