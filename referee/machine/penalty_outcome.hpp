// How a penalty kick ends, the order of kicks in a shoot-out, and when a shoot-out ends.
//
// A penalty kick fails if the ball goes out, if the keeper turns the ball's path by 90 degrees or
// more, or 10 s after the signal (2026, Penalty Kick; shoot-outs under all rule books). In 2026 it
// also fails if the ball does not "only move towards the opponent goal".
//
// In 2026, a foul decides the kick ("a goal is awarded if the defending team commits any foul; a
// goal is not awarded if the attacking team violates any rule"). In a shoot-out under the Laws, the
// kick is over after a foul by the kicker's side, or "as soon as the kicker touches the ball after
// he released it the first time" (appendix A).
//
// If play continues after a failed penalty kick (Laws 14), the same conditions decide when the
// rules on penalty kicks cease to apply.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "referee/machine/referee_state.hpp"
#include "referee/referee_configuration.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// The order of a shoot-out's kicks, and when it is decided (Laws 2014, appendix A; 2026).
//
// The sides alternate. The side that kicked off the game begins, so only the ends and the kick-off
// are decided by lot.

// If a shoot-out is still level after this many kicks per side, it is a draw. This is AutoRef's own
// limit, for teams that cannot score.
inline constexpr int kMostShootoutKicks = 50;

Side next_kicker(const ShootoutBook& book, const Configuration& configuration);

// Whether the remaining kicks can no longer change the winner. Each side has `kicks` kicks; after
// that, each side gets one more at a time.
bool is_decided(const ShootoutBook& book, int kicks);

// Whether the shoot-out is decided or the limit is reached.
bool is_over(const ShootoutBook& book, int kicks);

struct PenaltyFailure {
  double value = 0;  // measured value; threshold and unit follow, and the unit is empty if nothing
                     // was measured
  double threshold = 0;
  std::string_view unit;
  std::string evidence;
};

// Whether the ball is in the goal that the penalty kick is aimed at. Play must be a penalty kick.
bool is_penalty_goal(const RefereeState& state, const RefereeInput& input);

// Whether a goal is awarded because the defenders committed a foul during the penalty kick (2026).
// Play must be a penalty kick.
bool is_goal_awarded(const RefereeState& state, const RefereeInput& input);

// Why the penalty kick has failed; nullopt if it has not failed yet or is a goal. Play must be a
// penalty kick.
std::optional<PenaltyFailure> penalty_failure(const RefereeState& state, const RefereeInput& input);

// Whether the penalty kick is over, though play may continue. It is over if it is a goal, if it has
// failed or, under the Laws, if a robot other than the keeper has played the ball after the kick.
// Play must be a penalty kick.
bool is_penalty_over(const RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
