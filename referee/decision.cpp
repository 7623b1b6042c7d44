#include "referee/decision.hpp"

#include <array>

namespace autoref::referee {

std::string_view name_of(State state) {
  static constexpr std::array<std::string_view, 6> kNames = {"INIT", "WAIT_START", "WAIT_STOP",
                                                             "RUN",  "DELAY_WAIT", "OVER"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string_view name_of(Event event) {
  static constexpr std::array<std::string_view, kEventCount> kNames = {"begin",
                                                                       "robots_moved",
                                                                       "start_timeout",
                                                                       "ready",
                                                                       "ready_timeout",
                                                                       "goal",
                                                                       "throw_in",
                                                                       "corner_kick",
                                                                       "goal_kick",
                                                                       "touch_line_unknown",
                                                                       "attacker_near_area",
                                                                       "restart_not_taken",
                                                                       "stuck_ball",
                                                                       "signalled",
                                                                       "half_over",
                                                                       "game_over"};
  return kNames[static_cast<std::size_t>(event)];
}

bool is_stop(Event event) { return event >= Event::kGoal && event <= Event::kStuckBall; }

}  // namespace autoref::referee
