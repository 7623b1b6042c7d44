#include "referee/rules/double_touch.hpp"

#include <fmt/format.h>

#include "referee/ball_in_play.hpp"

namespace autoref::referee {

std::optional<Finding> find_double_touch(Memory& memory, const Moment& moment) {
  const PlayMemory& play = memory.play;
  const TouchHistory& touches = play.touches;
  if (!play.in_play || touches.count() < 2 || !is_straight_from_restart(play)) return std::nullopt;
  const BallTouch& again = *touches.newest();
  if (!(again.began_s > play.in_play_since_s) || !is_settled(again, moment.time_s())) {
    return std::nullopt;
  }
  Finding finding = offence_of(Event::kDoubleTouch, RuleId::kDoubleTouch, moment.configuration,
                               *again.robot, again.began_m);
  finding.value = (again.began_m - *play.ball_from_m).norm();
  finding.evidence = fmt::format(
      "{} took the restart and touched the ball again at {:.3f} s, {:.0f} mm away from there.",
      text_of(*again.robot), again.began_s, 1e3 * finding.value);
  return finding;
}

}  // namespace autoref::referee
