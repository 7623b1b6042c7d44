#include "referee/rules/stuck_ball.hpp"

#include <fmt/format.h>

#include "referee/geometry/restarts.hpp"

namespace autoref::referee {

std::optional<Finding> find_stuck_ball(Memory& memory, const Moment& moment) {
  const PlayMemory& play = memory.play;
  const Configuration& c = moment.configuration;
  if (!play.in_play || !moment.ball ||
      !has_passed(play.stuck_since_s, c.rules.stuck_time_s, moment.time_s())) {
    return std::nullopt;
  }
  Finding finding = finding_of(Event::kStuckBall, RuleId::kStuckBall, c.rules);
  finding.value = (moment.ball->position_m - play.stuck_at_m).norm();
  finding.position_m = moment.ball->position_m;
  finding.restart = {CommandKind::kForceStart, Side::kWest};
  finding.ball_to_m = neutral_place(c.field, c.rules, moment.ball->position_m);
  finding.evidence = fmt::format("Since {:.3f} s the ball has stayed within {:.0f} mm.",
                                 play.stuck_since_s, 1e3 * c.rules.stuck_distance_m);
  return finding;
}

}  // namespace autoref::referee
