// Which robots keep the goals in a recorded game.
#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

// How many frames each robot of a side is seen in, and in how many it is nearest to its own goal.
struct GoalDuty {
  std::array<int, kMaxRobots> frames{};
  std::array<int, kMaxRobots> nearest{};
  int all = 0;  // frames with any robot of the side
};

// The robot that keeps the goal, if positions contradict the announced keeper: in at least 100
// frames it is hardly ever nearest to its own goal. That is the robot which is nearest most of the
// time, or -1 if there is none.
std::optional<int> actual_keeper(const GoalDuty& duty, int announced);

// The actual keepers of a log's games; nullopt if the announced one keeps the goal, as far as can
// be seen. A keeper that is never announced is taken to be robot 0. Throws league::LogError.
PerSide<std::optional<int>> actual_keepers(const std::filesystem::path& log, const Field& field);

}  // namespace autoref::runner
