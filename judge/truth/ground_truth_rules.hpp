// Factories of the ground-truth rules (each file documents the events it reports), and what several
// files share: fouls that are counted per team.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "judge/truth/true_frame.hpp"
#include "soccer/units.hpp"

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

// 2026 rules, "Offenses": a team's grace period before the same foul is raised again.
inline constexpr double kTeamGrace_s = 2_s;

// With a tolerance of half a frame, since time is quantised to frames.
bool has_passed(const TrueFrame& frame, double since_s, double duration_s);

// The robot of a team farthest beyond a threshold; `excess` is in the threshold's unit.
struct WorstRobot {
  std::optional<RobotId> robot;
  Vec2 position_m{0, 0};
  double excess = 0;

  void consider(RobotId id, const sim::RobotState& state, double its_excess);
};

// A foul of the 2026 rules that is counted per team, whichever of its robots commits it. Several
// offending robots of a team within the grace period are a single foul. After it, the foul is
// raised again as soon as the team commits it again, or at once if it still does.
class TeamFoul {
 public:
  // `margin`: distance to the threshold within which the rules leave a foul open to interpretation,
  // in the threshold's unit.
  TeamFoul(std::string_view name, double margin) : name_(name), margin_(margin) {}

  // Call in every frame in which the rule applies. Returns whether the foul is raised in this
  // frame.
  bool watch(const TrueFrame& frame, Side side, const WorstRobot& worst, TrueEvents& all);
  // Starts the grace period as if the team's foul had been raised at that time.
  void begin_grace(Side side, double time_s) { raised_s_[side] = nearly_s_[side] = time_s; }

 private:
  std::string_view name_;
  double margin_;
  PerSide<double> raised_s_{{-1e9, -1e9}};
  PerSide<double> nearly_s_{{-1e9, -1e9}};  // latest foul or near miss
};

}  // namespace autoref::judge::ground_truth
