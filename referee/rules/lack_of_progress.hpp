// How long a ball in play has made no progress, as judged by rules stuck_ball and
// no_progress_in_game.
#pragma once

#include <optional>

#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// Since when the ball has moved less than `RuleBook::stuck_distance_m`, if that is
// `RuleBook::stuck_time_s` ago. While the keeper may hold the ball in its defence area, its own
// limit applies (rule keeper_held_ball): that time does not count here.
std::optional<double> without_progress_since_s(const RefereeState& state,
                                               const RefereeInput& input);

}  // namespace autoref::referee
