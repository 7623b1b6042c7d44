#include "judge/truth/ground_truth_rules.hpp"

namespace autoref::judge::ground_truth {
namespace {

using Maker = std::unique_ptr<GroundTruthRule> (*)();

struct Entry {
  RuleId rule;
  Maker make;
  Maker make_2026;  // replacement if the 2026 rules differ
};

// Fouls come first, since a goal may depend on them.
constexpr Entry kEntries[] = {
    {RuleId::kBotKickedBallTooFast, bot_kicked_ball_too_fast, nullptr},
    {RuleId::kAttackerDoubleTouchedBall, attacker_double_touched_ball, nullptr},
    {RuleId::kBotDribbledBallTooFar, bot_dribbled_ball_too_far, nullptr},
    {RuleId::kKeeperHeldBall, keeper_held_ball, nullptr},
    {RuleId::kBotCrashUnique, bot_crash_unique, nullptr},
    {RuleId::kBotPushedBot, bot_pushed_bot, nullptr},
    {RuleId::kOffside, offside, nullptr},
    {RuleId::kRestartNotTaken, untaken_restart, nullptr},
    {RuleId::kBotTooFastInStop, bot_too_fast_in_stop, bot_too_fast_in_stop_2026},
    {RuleId::kStopDistance, stop_distance, nullptr},
    {RuleId::kBotInterferedPlacement, bot_interfered_placement, nullptr},
    {RuleId::kTooManyRobots, too_many_robots, too_many_robots_2026},
};

}  // namespace

std::vector<std::unique_ptr<GroundTruthRule>> ground_truth_rules_of(const RuleBook& rules) {
  std::vector<std::unique_ptr<GroundTruthRule>> makers;
  const bool is_2026 = rules.edition == Edition::kRules2026;
  for (const Entry& entry : kEntries) {
    if (!rules.has(entry.rule)) continue;
    makers.push_back(is_2026 && entry.make_2026 != nullptr ? entry.make_2026() : entry.make());
  }
  if (is_2026) {
    if (rules.has(RuleId::kAttackerTooCloseToDefenseArea)) makers.push_back(attacker_stays());
    if (rules.has(RuleId::kDefenderTooCloseToKickPoint)) makers.push_back(opponents_near_restart());
  }
  if (rules.has(RuleId::kDefenderInDefenseArea) ||
      rules.has(RuleId::kAttackerTouchedBallInDefenseArea)) {
    makers.push_back(touches_in_areas());
  }
  if (rules.has(RuleId::kStuckBall) || rules.has(RuleId::kNoProgressInGame)) {
    makers.push_back(stuck_ball());
  }
  makers.push_back(penalty());  // any rule book may lead to a shoot-out
  makers.push_back(positions_at_entry());
  makers.push_back(ball_out());
  // Cards come last, since they count the fouls of the frame.
  if (is_2026 && rules.has(RuleId::kCards)) makers.push_back(multiple_fouls());
  return makers;
}

bool has_passed(const TrueFrame& frame, double since_s, double duration_s) {
  return frame.time_s - since_s >= duration_s - frame.frame_s / 2;
}

void WorstRobot::consider(RobotId id, const sim::RobotState& state, double its_excess) {
  if (robot && its_excess <= excess) return;
  robot = id;
  position_m = state.position_m;
  excess = its_excess;
}

bool TeamFoul::watch(const TrueFrame& frame, Side side, const WorstRobot& worst, TrueEvents& all) {
  const bool is_near = worst.robot && worst.excess > -margin_;
  if (!is_near || !has_passed(frame, raised_s_[side], kTeamGrace_s)) return false;
  const bool is_foul = worst.excess > 0;
  if (!is_foul && !has_passed(frame, nearly_s_[side], kTeamGrace_s)) return false;
  nearly_s_[side] = frame.time_s;
  if (is_foul) raised_s_[side] = frame.time_s;
  add_measured(all, {name_, frame.time_s, side, worst.robot, worst.position_m}, worst.excess,
               margin_);
  return is_foul;
}

}  // namespace autoref::judge::ground_truth
