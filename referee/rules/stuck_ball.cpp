// Deviation D11: a ball in play that has moved less than 250 mm in 10 s is stuck. Play continues
// with a force start from a neutral position (2016; Laws 2014, law 9).
#include <fmt/format.h>

#include "referee/geometry/restarts.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> find_stuck_ball(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  const Configuration& c = input.configuration;
  if (!play.in_play || !input.ball ||
      !has_passed(play.stuck_since_s, c.rules.stuck_time_s, input.time_s())) {
    return std::nullopt;
  }
  Finding finding = finding_of(Event::kStuckBall, RuleId::kStuckBall, c.rules);
  finding.value = (input.ball->position_m - play.stuck_at_m).norm();
  finding.position_m = input.ball->position_m;
  finding.details.waited_s = input.time_s() - play.stuck_since_s;
  finding.ball_to_m = neutral_position(c.field, c.rules, input.ball->position_m);
  finding.evidence = fmt::format("The ball has moved less than {1:.0f} mm since {0:.3f} s.",
                                 play.stuck_since_s, 1e3 * c.rules.stuck_distance_m);
  return finding;
}

}  // namespace

constinit const Rule kStuckBallRule{{State::kRun}, find_stuck_ball};

}  // namespace autoref::referee
