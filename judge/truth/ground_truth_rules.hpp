// Factories of the ground-truth rules; each file documents the events it reports.
#pragma once

#include <memory>
#include <vector>

#include "judge/truth/scene.hpp"

namespace autoref::judge::ground_truth {

std::unique_ptr<GroundTruthRule> ball_out();  // valid or invalid goals, ball over the lines
std::unique_ptr<GroundTruthRule> bot_kicked_ball_too_fast();
std::unique_ptr<GroundTruthRule> attacker_double_touched_ball();
std::unique_ptr<GroundTruthRule> bot_dribbled_ball_too_far();
std::unique_ptr<GroundTruthRule> keeper_held_ball();
std::unique_ptr<GroundTruthRule> touches_in_areas();  // defender (partly) in area, attacker in area
std::unique_ptr<GroundTruthRule> bot_crash_unique();  // and bot_crash_drawn
std::unique_ptr<GroundTruthRule> bot_pushed_bot();
std::unique_ptr<GroundTruthRule>
positions_at_entry();  // robots at illegal positions when the ball enters play
std::unique_ptr<GroundTruthRule> offside();
std::unique_ptr<GroundTruthRule> untaken_restart();
std::unique_ptr<GroundTruthRule> penalty();     // penalty_kick_failed and penalty_positions
std::unique_ptr<GroundTruthRule> stuck_ball();  // and no_progress_in_game
std::unique_ptr<GroundTruthRule> bot_too_fast_in_stop();
std::unique_ptr<GroundTruthRule> bot_too_fast_in_stop_2026();
std::unique_ptr<GroundTruthRule> stop_distance();
std::unique_ptr<GroundTruthRule> attacker_stays();  // near the defence area, 2026 rules
std::unique_ptr<GroundTruthRule>
opponents_near_restart();  // defender_too_close_to_kick_point, 2026 rules
std::unique_ptr<GroundTruthRule> bot_interfered_placement();
std::unique_ptr<GroundTruthRule> too_many_robots();
std::unique_ptr<GroundTruthRule> too_many_robots_2026();
std::unique_ptr<GroundTruthRule> multiple_fouls();  // yellow cards of 2026

// The ground-truth rules for this rule book.
std::vector<std::unique_ptr<GroundTruthRule>> ground_truth_rules_of(const RuleBook& rules);

}  // namespace autoref::judge::ground_truth
