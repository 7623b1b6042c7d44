// The truths, one maker each; which rules they tell stands in their files.
#pragma once

#include <memory>
#include <vector>

#include "runner/judge/truth/scene.hpp"

namespace autoref::runner::ground_truth {

std::unique_ptr<GroundTruthRule>
ball_out();  // goals, goals that do not count, exits, aimless kicks
std::unique_ptr<GroundTruthRule> kick_speed();
std::unique_ptr<GroundTruthRule> double_touch();
std::unique_ptr<GroundTruthRule> dribbling();
std::unique_ptr<GroundTruthRule> keeper_holding();
std::unique_ptr<GroundTruthRule> touches_in_areas();  // defender (partly) in area, attacker in area
std::unique_ptr<GroundTruthRule> crash();             // and crash_drawn
std::unique_ptr<GroundTruthRule> pushing();
std::unique_ptr<GroundTruthRule>
positions_at_entry();  // robots misplaced when the ball enters play
std::unique_ptr<GroundTruthRule> untaken_restart();
std::unique_ptr<GroundTruthRule> penalty();     // penalty_failed and penalty_positions
std::unique_ptr<GroundTruthRule> stuck_ball();  // and no_progress
std::unique_ptr<GroundTruthRule> stop_speed();
std::unique_ptr<GroundTruthRule> stop_distance();
std::unique_ptr<GroundTruthRule> attacker_stays();          // near the area, rules of 2026
std::unique_ptr<GroundTruthRule> opponents_near_restart();  // restart_distance, rules of 2026
std::unique_ptr<GroundTruthRule> placement_interference();
std::unique_ptr<GroundTruthRule> too_many_robots();

// Those that the book has in force.
std::vector<std::unique_ptr<GroundTruthRule>> ground_truth_rules_of(const RuleBook& rules);

}  // namespace autoref::runner::ground_truth
