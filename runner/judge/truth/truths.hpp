// The truths, one maker each; which rules they tell stands in their files.
#pragma once

#include <memory>
#include <vector>

#include "runner/judge/truth/scene.hpp"

namespace autoref::runner::truth {

std::unique_ptr<Truth> ball_out();  // goals, goals that do not count, exits, aimless kicks
std::unique_ptr<Truth> kick_speed();
std::unique_ptr<Truth> double_touch();
std::unique_ptr<Truth> dribbling();
std::unique_ptr<Truth> keeper_holding();
std::unique_ptr<Truth> touches_in_areas();  // defender (partly) in area, attacker in area
std::unique_ptr<Truth> crash();             // and crash_drawn
std::unique_ptr<Truth> pushing();
std::unique_ptr<Truth> positions_at_entry();  // robots misplaced when the ball enters play
std::unique_ptr<Truth> untaken_restart();
std::unique_ptr<Truth> penalty();     // penalty_failed and penalty_positions
std::unique_ptr<Truth> stuck_ball();  // and no_progress
std::unique_ptr<Truth> stop_speed();
std::unique_ptr<Truth> stop_distance();
std::unique_ptr<Truth> attacker_stays();          // near the area, rules of 2026
std::unique_ptr<Truth> opponents_near_restart();  // restart_distance, rules of 2026
std::unique_ptr<Truth> placement_interference();
std::unique_ptr<Truth> too_many_robots();

// Those that the book has in force.
std::vector<std::unique_ptr<Truth>> truths_of(const RuleBook& rules);

}  // namespace autoref::runner::truth
