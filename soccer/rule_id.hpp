// The referee's rules by name: what a rule book holds and a game file switches.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace autoref {

enum class RuleId : std::uint8_t {
  kGoal,
  kBallLeavesField,
  kAttackerNearArea,
  kRestartNotTaken,
  kStuckBall,
  kNoProgress,
  kKickSpeed,
  kChipGoal,
  kGoalValid,
  kIndirectGoal,
  kFreeKickOwnGoal,
  kDefenderInArea,
  kAttackerInArea,
  kDoubleTouch,
  kRestartDistance,
  kStopSpeed,
  kStopDistance,
  kDribbling,
  kKeeperHolding,
  kCrash,
  kPushing,
  kPlacementInterference,
  kTooManyRobots,
  kKickoffPositions,
  kPenaltyPositions,
  kPenaltyFailed,
  kAimlessKick,
  kOffside,
  kCards,
  kTimeouts,
  kGoalLead,
};
inline constexpr int kRuleCount = static_cast<int>(RuleId::kGoalLead) + 1;

// A short name in snake_case, as in game files: "kick_speed".
std::string_view name_of(RuleId rule);
std::optional<RuleId> find_rule(std::string_view name);

// The rules in force.
class RuleSet {
 public:
  constexpr RuleSet() = default;
  constexpr RuleSet(std::initializer_list<RuleId> rules) { add(rules); }

  constexpr bool has(RuleId rule) const { return in_force_[static_cast<std::size_t>(rule)]; }
  // To switch a rule on or off.
  constexpr bool& operator[](RuleId rule) { return in_force_[static_cast<std::size_t>(rule)]; }
  constexpr void add(std::initializer_list<RuleId> rules) {
    for (const RuleId rule : rules) (*this)[rule] = true;
  }
  bool operator==(const RuleSet&) const = default;

 private:
  std::array<bool, kRuleCount> in_force_{};
};

}  // namespace autoref
