// The rules in force and their parameters, each with its source.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/rule_id.hpp"
#include "soccer/units.hpp"

namespace autoref {

// Which edition a rule book follows; the divisions within an edition differ in numbers.
enum class Edition : std::uint8_t { kPaper, kLaws2014, kRules2026 };

// The rules of an edition, from rules.def. For the paper: the rules it describes (section 4.2) and
// those needed for games to end.
RuleSet rules_of(Edition edition);

// The defaults are those of `rules: paper`; for rules that the paper lacks, they are the Laws'
// numbers for single size. "Paper" is Zhu, Biswas and Veloso, "AutoRef: Towards Real-Robot Soccer
// Complete Automated Refereeing"; "Laws" are the SSL's laws of 2014; "2016" is the authors' later
// public referee; "2026" are the SSL's rules of that year, Divisions A and B. "Our choice" marks
// numbers without a published source.
struct RuleBook {
  std::string name = "paper";
  Edition edition = Edition::kPaper;
  RuleSet in_force = rules_of(Edition::kPaper);

  // Readiness before a restart (paper, section 4.4).
  double stillness_m = 15_mm;          // the paper's epsilon
  double readiness_period_s = 1_s;     // our choice; the paper says "periodically"
  double ready_timeout_s = 15_s;       // 2016; the paper says "a fixed timeout"
  double start_timeout_s = 10_s;       // our choice: clients that never move must not stall a game
  double ball_at_rest_mps = 0.05_mps;  // our choice: "rests at its place"
  double ball_in_position_m = 10_mm;   // our choice: "rests at its place"

  // Where the ball is placed (paper, section 4.2).
  double throw_in_inset_m = 100_mm;
  double corner_inset_m = 100_mm;           // from touch line and goal line
  double goal_kick_touch_inset_m = 100_mm;  // from the nearest touch line
  double goal_kick_goal_inset_m = 500_mm;   // from the goal line

  // Restarts (Laws 8, 9, 13).
  bool kicks_may_score = false;            // from any free kick (2026), else only from a direct one
  double in_play_m = 50_mm;                // move that starts play; also the double-touch limit
  double restart_timeout_s = 10_s;         // kick-off and penalty
  double free_kick_timeout_s = 10_s;       // 2026 Division A: 5 s
  bool untaken_goes_to_opponents = false;  // 2026: with a free kick; otherwise force start
  double opponents_to_ball_m = 500_mm;     // minimum, for opponents at every restart
  double attacker_to_area_m = 200_mm;      // paper, section 4.2, robot-related rules
  double attacker_grace_s = 2_s;           // 2026: counted from the start of the stop

  // Where a free kick is taken if the offence was too near to a defence area (Laws 13).
  double own_area_kick_goal_inset_m = 600_mm;   // in the team's own area: from the goal line
  double own_area_kick_touch_inset_m = 100_mm;  // and from the touch line
  double free_kick_to_area_m = 700_mm;  // attackers: from the opponents' area; 2026: from both

  // A ball that makes no progress (2016; 2026).
  double stuck_time_s = 10_s;
  double stuck_distance_m = 250_mm;
  double neutral_to_area_m = 700_mm;  // from a neutral spot to both areas

  // The ball in play (Laws 12).
  double kick_limit_mps = 8_mps;  // paper, section 3; the teams keep to it; 2026: 6.5 m/s in 3D
  double chip_height_m = 150_mm;  // height of the ball's top; a higher chip must not score directly
  double dribbling_m = 500_mm;    // Laws 2014; 1000 mm from 2015
  double keeper_holding_s = 15_s;  // 2026: 10 s, Division A 5 s
  double goal_after_foul_s = 2_s;  // 2026: a goal within this time after its team fouls is invalid
  double pushing_m = 200_mm;       // 2026
  double crash_mps = 1.5_mps;      // along the line between the robots
  double crash_drawn_mps = 0.3_mps;  // both are at fault if their speeds differ by less

  // While play is stopped (Laws 12).
  double stop_speed_mps = 1.0_mps;        // single size; double size and later editions: 1.5
  double stop_grace_s = 2_s;              // 2026
  double placement_clearance_m = 500_mm;  // 2026: from the line between ball and target
  double placement_grace_s = 2_s;         // 2026
  bool fouls_stop_play = true;            // 2026: some are only counted, and play continues
  double foul_repeat_s = 2_s;             // 2026: until the same foul of a team counts again
  double interference_s = 10_s;           // 2026: extra placement time after an interference

  // Ball placement by the teams' robots (2026, Ball Placement).
  double placement_time_s = 30_s;            // from the command
  double placement_least_s = 2_s;            // the game does not continue earlier
  double placement_tolerance_m = 150_mm;     // from the ball to its target
  double placement_robots_m = 50_mm;         // from the ball to all robots before a free kick
  double placement_robots_force_m = 500_mm;  // and before a force start
  double placement_not_needed_m = 1_m;  // a ball at rest may stay if it is nearer to its target
  double placement_to_area_m = 700_mm;  // and farther from both defence areas
  int placement_failures = 5;           // a team with as many places no ball for a half

  // Penalty kicks (Laws 14).
  double penalty_clearance_m = 400_mm;  // from the mark back to the other robots; 2026: 1 m
  double penalty_time_s = 10_s;         // 2026: to score; in shoot-outs, all rule books
  double penalty_turn_deg = 90;  // 2026: failed once the keeper deflects the ball by this angle
  bool penalty_fouls_decide = false;   // 2026: the kicker's side's: no goal; the defenders': a goal
  bool penalty_prolongs_half = false;  // Laws; 2026: a half ends after a penalty kick awarded in it

  // Cards (Laws 12).
  double card_s = 120_s;     // counted in playing time
  int fouls_per_card = 0;    // 2026: every third foul; 0: none
  int yellows_per_red = 0;   // 2026: the third active yellow card; 0: none
  double too_many_s = 10_s;  // 2026: to remove a robot

  // Timeouts of each team (Laws 7).
  int timeouts = 4;
  double timeouts_s = 300_s;  // in total
  int extra_timeouts = 2;     // in extra time, replacing unused ones (Laws, appendix A)
  double extra_timeouts_s = 300_s;

  // The end of the game (2026): a team wins with this many goals and a lead of more than
  // `goal_lead`; 0: never.
  int goals_to_win = 0;
  int goal_lead = 1;
  bool clock_stops = false;  // 2026: during halt, stop, preparation and placement
  // Teams change ends before every half after the first (Laws 8; 2026: the toss decides which goal
  // a team attacks in the first half; before extra time: our choice). The paper's teams do not.
  bool change_ends = false;
  double extra_half_s = 300_s;  // in knockout games (Laws, appendix A)
  int shootout_kicks = 5;       // per team, before sudden death

  bool has(RuleId rule) const { return in_force.has(rule); }
  bool operator==(const RuleBook&) const = default;
};

// Defaults for games under a rule book.
struct GameSetup {
  Field field;
  int robots = 6;  // per team
  double half_s = 600;
  // Kickers and dribblers: a preset of sim/robot_presets.hpp.
  std::string kickers_and_dribblers = "default";
  double latency_error_s = 0;  // sim/configuration.hpp
};

// The rule book of that name; nullopt if the name is unknown.
std::optional<RuleBook> find_rule_book(std::string_view name);
std::vector<std::string> rule_book_names();

// The setup for the rule book of that name; nullopt if the name is unknown.
std::optional<GameSetup> find_game_setup(std::string_view name);

}  // namespace autoref
