#include "strategies/rowdy/kinds.hpp"

#include <array>

namespace autoref::strategies::rowdy {

std::span<const FoulBehaviour* const, kKindCount> all_kinds() {
  static constexpr std::array<const FoulBehaviour*, kKindCount> kAll = {
      &kAimlessKick,   &kAttackInArea, &kChipGoal,    &kCrowdRestart,  &kDelay,
      &kHardKick,      &kIndirectShot, &kKeeperHold,  &kKeeperOffLine, &kKickoffIntruder,
      &kLongDribble,   &kNearArea,     &kOwnGoalKick, &kPenaltyCrowd,  &kPlayAtOwnArea,
      &kPlayInOwnArea, &kRam,          &kRamEvenly,   &kSecondTouch,   &kShove,
      &kStopCrowd,     &kStopSprint,   &kTimeout};
  return kAll;
}

}  // namespace autoref::strategies::rowdy
