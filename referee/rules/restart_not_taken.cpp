#include "referee/rules/restart_not_taken.hpp"

#include <fmt/format.h>

namespace autoref::referee {

std::optional<Finding> find_restart_not_taken(Memory& memory, const Moment& moment) {
  const PlayMemory& play = memory.play;
  const RuleBook& rules = moment.configuration.rules;
  if (play.in_play || !has_passed(play.began_s, rules.restart_timeout_s, moment.time_s())) {
    return std::nullopt;
  }
  Finding finding;
  finding.event = Event::kRestartNotTaken;
  finding.rule = "Laws 2014, 8 and 9; 2016";
  finding.value = moment.time_s() - play.began_s;
  finding.threshold = rules.restart_timeout_s;
  finding.unit = "s";
  finding.position_m = play.ball_from_m;
  finding.restart = {CommandKind::kForceStart, Side::kWest};
  finding.ball_to_m = play.ball_from_m.value_or(Vec2(0, 0));
  finding.evidence =
      fmt::format("{} was signalled at {:.3f} s, and the ball has not moved {:.0f} mm.",
                  name_of(play.began_with), play.began_s, 1e3 * rules.in_play_m);
  return finding;
}

}  // namespace autoref::referee
