#include "referee/decision.hpp"

#include <array>

namespace autoref::referee {

std::string_view name_of(State state) {
  static constexpr std::array<std::string_view, 7> kNames = {
      "INIT", "WAIT_START", "WAIT_STOP", "RUN", "DELAY_WAIT", "OVER", "TIMEOUT"};
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
                                                                       "game_over",
                                                                       "no_progress",
                                                                       "kick_speed",
                                                                       "chip_goal",
                                                                       "goal_invalid",
                                                                       "indirect_goal",
                                                                       "free_kick_own_goal",
                                                                       "defender_in_area",
                                                                       "defender_partly_in_area",
                                                                       "attacker_in_area",
                                                                       "double_touch",
                                                                       "restart_distance",
                                                                       "dribbling",
                                                                       "keeper_holding",
                                                                       "crash",
                                                                       "pushing",
                                                                       "too_many_robots",
                                                                       "kickoff_positions",
                                                                       "penalty_positions",
                                                                       "penalty_failed",
                                                                       "aimless_kick",
                                                                       "offside",
                                                                       "goal_line_unknown",
                                                                       "crash_drawn",
                                                                       "attacker_stays_near_area",
                                                                       "stop_speed",
                                                                       "stop_distance",
                                                                       "placement_interference",
                                                                       "yellow_card",
                                                                       "red_card",
                                                                       "card_over",
                                                                       "timeout",
                                                                       "timeout_over",
                                                                       "goal_lead",
                                                                       "extra_time",
                                                                       "shootout",
                                                                       "shootout_over"};
  return kNames[static_cast<std::size_t>(event)];
}

bool is_call(Event event) {
  const bool is_papers = event >= Event::kGoal && event <= Event::kStuckBall;
  return is_papers || (event >= Event::kNoProgress && event <= Event::kPlacementInterference);
}

std::string_view name_of(Card card) {
  static constexpr std::array<std::string_view, 3> kNames = {"none", "yellow", "red"};
  return kNames[static_cast<std::size_t>(card)];
}

}  // namespace autoref::referee
