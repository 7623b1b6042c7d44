// The kicker of a restart must not touch the ball again, once the kick is over, before another
// robot has touched it (Laws 2014, laws 8 and 13 to 17; 2026, Double Touch). The kick is over once
// the ball has been in play for RuleBook::double_touch_s and has moved farther than
// RuleBook::double_touch_m. "Again" means after ball and robot have separated, so several contacts
// during the kick count as one touch. A touch by an unknown robot may have been made by another
// robot, so it is not penalised.
#include <fmt/format.h>

#include "referee/machine/ball_in_play.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {

namespace {

// "Remaining in contact with the ball for more than 0.05 meters also counts" (2026).
bool stays_in_contact(const PlayState& play, const RefereeInput& input) {
  if (input.configuration.rules.edition != Edition::kRules2026) return false;
  const BallTouch* touch = play.touches.newest();
  if (touch == nullptr || !touch->robot) return false;
  const double carried_m = (touch->ended_m - *play.ball_from_m).norm();
  return touch->began_s <= *play.kick_ended_s && touch->ended_s > *play.kick_ended_s &&
         carried_m >
             input.configuration.rules.double_touch_m + 3 * input.configuration.noise.ball_m;
}

bool touches_again(const PlayState& play, const RefereeInput& input) {
  if (play.touches.count() < 2) return false;
  const BallTouch& again = *play.touches.newest();
  return again.began_s > *play.kick_ended_s && is_settled(again, input.time_s());
}

std::optional<Finding> find_attacker_double_touched_ball(RefereeState& state,
                                                         const RefereeInput& input) {
  const PlayState& play = state.play;
  if (!play.kick_ended_s || !is_straight_from_restart(play)) return std::nullopt;
  // The rule of 2026 applies "following a kick-off or free kick". At penalty kicks, the rule
  // applies only under the Laws.
  const bool is_2026 = input.configuration.rules.edition == Edition::kRules2026;
  if (is_2026 && play.is_penalty()) return std::nullopt;
  if (!touches_again(play, input) && !stays_in_contact(play, input)) return std::nullopt;
  const BallTouch& again = *play.touches.newest();
  Finding finding =
      offence_of(Event::kAttackerDoubleTouchedBall, RuleId::kAttackerDoubleTouchedBall,
                 input.configuration, *again.robot, again.ended_m);
  finding.value = (again.ended_m - *play.ball_from_m).norm();
  finding.evidence = fmt::format(
      "{} took the restart and touched the ball again at {:.3f} s, {:.0f} mm from its position.",
      text_of(*again.robot), again.ended_s, 1e3 * finding.value);
  return finding;
}

}  // namespace

constinit const Rule kAttackerDoubleTouchedBallRule{{State::kRun},
                                                    find_attacker_double_touched_ball};

}  // namespace autoref::referee
