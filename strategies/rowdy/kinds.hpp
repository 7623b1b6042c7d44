// All foul behaviours of `rowdy`, one file each in kinds/.
#pragma once

#include <span>

#include "strategies/rowdy/foul_behaviour.hpp"

namespace autoref::strategies::rowdy {

extern const FoulBehaviour kAimlessKick;
extern const FoulBehaviour kAttackInArea;
extern const FoulBehaviour kChipGoal;
extern const FoulBehaviour kCrowdRestart;
extern const FoulBehaviour kDelay;
extern const FoulBehaviour kHardKick;
extern const FoulBehaviour kIndirectShot;
extern const FoulBehaviour kKeeperHold;
extern const FoulBehaviour kKeeperOffLine;
extern const FoulBehaviour kKickoffIntruder;
extern const FoulBehaviour kLongDribble;
extern const FoulBehaviour kNearArea;
extern const FoulBehaviour kOwnGoalKick;
extern const FoulBehaviour kPenaltyCrowd;
extern const FoulBehaviour kPlayAtOwnArea;
extern const FoulBehaviour kPlayInOwnArea;
extern const FoulBehaviour kRam;
extern const FoulBehaviour kRamEvenly;
extern const FoulBehaviour kSecondTouch;
extern const FoulBehaviour kShove;
extern const FoulBehaviour kStopCrowd;
extern const FoulBehaviour kStopSprint;
extern const FoulBehaviour kTimeout;

inline constexpr int kKindCount = 23;

// All kinds, in the order in which opportunities in the same frame are considered.
std::span<const FoulBehaviour* const, kKindCount> all_kinds();

}  // namespace autoref::strategies::rowdy
