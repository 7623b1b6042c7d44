// All the mischief that `rowdy` knows, one file each in kinds/.
#pragma once

#include <span>

#include "strategies/rowdy/mischief.hpp"

namespace autoref::strategies::rowdy {

extern const Mischief kAimlessKick;
extern const Mischief kAttackInArea;
extern const Mischief kChipGoal;
extern const Mischief kCrowdRestart;
extern const Mischief kDelay;
extern const Mischief kHardKick;
extern const Mischief kIndirectShot;
extern const Mischief kKeeperHold;
extern const Mischief kKeeperOffLine;
extern const Mischief kKickoffIntruder;
extern const Mischief kLongDribble;
extern const Mischief kNearArea;
extern const Mischief kOwnGoalKick;
extern const Mischief kPenaltyCrowd;
extern const Mischief kPlayAtOwnArea;
extern const Mischief kPlayInOwnArea;
extern const Mischief kRam;
extern const Mischief kRamEvenly;
extern const Mischief kSecondTouch;
extern const Mischief kShove;
extern const Mischief kStopCrowd;
extern const Mischief kStopSprint;
extern const Mischief kTimeout;

inline constexpr int kKindCount = 23;

// In the order in which chances of the same frame are asked about.
std::span<const Mischief* const, kKindCount> all_kinds();

}  // namespace autoref::strategies::rowdy
