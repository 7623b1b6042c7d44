// How a penalty kick ends.
//
// It fails when the ball goes out, when the keeper turns its way by 90 degrees or more, or when
// 10 s have passed since the signal (2026, Penalty Kick; shoot-outs of all books). Where play goes
// on after a penalty kick (Laws 14), the same says when its own rules have ended.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

struct PenaltyFailure {
  double value = 0;  // measured, with its threshold and unit
  double threshold = 0;
  std::string_view unit;
  std::string evidence;
};

// Whether the ball is in the goal that the penalty kick is aimed at. The play must be a penalty
// kick.
bool is_penalty_goal(const RefereeState& state, const RefereeInput& input);

// Why the penalty kick has failed, or none where it has not yet; never where it is a goal. The play
// must be a penalty kick.
std::optional<PenaltyFailure> penalty_failure(const RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
