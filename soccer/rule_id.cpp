#include "soccer/rule_id.hpp"

#include <algorithm>

namespace autoref {
namespace {

constexpr std::array<std::string_view, kRuleCount> kNames = {"goal",
                                                             "ball_leaves_field",
                                                             "attacker_near_area",
                                                             "restart_not_taken",
                                                             "stuck_ball",
                                                             "no_progress",
                                                             "kick_speed",
                                                             "chip_goal",
                                                             "goal_valid",
                                                             "indirect_goal",
                                                             "free_kick_own_goal",
                                                             "defender_in_area",
                                                             "attacker_in_area",
                                                             "double_touch",
                                                             "restart_distance",
                                                             "stop_speed",
                                                             "stop_distance",
                                                             "dribbling",
                                                             "keeper_holding",
                                                             "crash",
                                                             "pushing",
                                                             "placement_interference",
                                                             "too_many_robots",
                                                             "kickoff_positions",
                                                             "penalty_positions",
                                                             "penalty_failed",
                                                             "aimless_kick",
                                                             "offside",
                                                             "cards",
                                                             "timeouts",
                                                             "goal_lead"};

}  // namespace

std::string_view name_of(RuleId rule) { return kNames[static_cast<std::size_t>(rule)]; }

std::optional<RuleId> find_rule(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<RuleId>(found - kNames.begin());
}

}  // namespace autoref
