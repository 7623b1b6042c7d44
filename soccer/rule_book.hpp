// The numbers of the rules in force, each with its source.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/units.hpp"

namespace autoref {

// Defaults are `rules: paper`. "Paper" is Zhu, Biswas and Veloso, "AutoRef: Towards Real-Robot
// Soccer Complete Automated Refereeing"; "Laws" are the SSL's laws of 2014; "2016" is the authors'
// later public referee.
struct RuleBook {
  std::string name = "paper";

  // Readiness before a restart (paper, section 4.4).
  double stillness_m = 15_mm;          // the paper's epsilon
  double look_period_s = 1_s;          // ours; the paper says "periodically"
  double ready_timeout_s = 15_s;       // 2016; the paper says "a fixed timeout"
  double start_timeout_s = 10_s;       // ours: clients that never move must not hang a game
  double ball_at_rest_mps = 0.05_mps;  // ours: "rests at its place"
  double ball_in_place_m = 10_mm;      // ours: "rests at its place"

  // Where the ball is put (paper, section 4.2).
  double throw_in_inset_m = 100_mm;
  double corner_inset_m = 100_mm;           // from touch line and goal line
  double goal_kick_touch_inset_m = 100_mm;  // from the nearest touch line
  double goal_kick_goal_inset_m = 500_mm;   // from the goal line

  // Ball in play and distances at restarts (Laws 8, 9, 13).
  double in_play_m = 50_mm;
  double restart_timeout_s = 10_s;
  double opponents_to_ball_m = 500_mm;  // kept by the teams at every restart
  double attacker_to_area_m = 200_mm;   // paper, section 4.2, robot-related rules
  double kick_limit_mps = 8_mps;        // paper, section 3; kept by the teams

  // Where a free kick is taken when it happened too near to an area (Laws 13).
  double own_area_kick_goal_inset_m = 600_mm;   // out of one's own area: from the goal line
  double own_area_kick_touch_inset_m = 100_mm;  // and from the touch line
  double free_kick_to_area_m = 700_mm;          // attackers: from the opponents' area

  // Stuck ball (2016).
  double stuck_time_s = 10_s;
  double stuck_distance_m = 250_mm;
  double neutral_to_area_m = 700_mm;  // from a neutral place to both areas

  bool operator==(const RuleBook&) const = default;
};

// The rule book of that name, or none.
std::optional<RuleBook> find_rule_book(std::string_view name);
std::vector<std::string> rule_book_names();

}  // namespace autoref
