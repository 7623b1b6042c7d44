#include "referee/rules/lack_of_progress.hpp"

#include <algorithm>

namespace autoref::referee {

std::optional<double> without_progress_since_s(const RefereeState& state,
                                               const RefereeInput& input) {
  const PlayState& play = state.play;
  if (!play.in_play || !input.ball) return std::nullopt;
  const double kept_s = state.watch.keeper_held_ball.last_s.value_or(play.stuck_since_s);
  const double since_s = std::max(play.stuck_since_s, kept_s);
  const bool is_long = has_passed(since_s, input.configuration.rules.stuck_time_s, input.time_s());
  return is_long ? std::optional(since_s) : std::nullopt;
}

}  // namespace autoref::referee
