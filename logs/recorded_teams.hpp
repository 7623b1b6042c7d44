// Finds out which end each team of a recorded game defends and which robots keep the goals.
#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "league/log_contents.hpp"
#include "logs/recorded_ends.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// For each robot of a side, the number of frames in which it is the side's robot nearest to its own
// goal.
struct GoalDuty {
  std::array<int, kMaxRobots> nearest{};
  int all = 0;  // number of frames with any robot of the side
};

// The robot that actually keeps the goal, if positions contradict the announced keeper: in at least
// 100 frames, that robot is hardly ever nearest to its own goal. The actual keeper is the robot
// that is nearest most of the time, or -1 if there is none. nullopt if positions do not contradict
// the announced keeper.
std::optional<int> actual_keeper(const GoalDuty& duty, int announced);

struct RecordedTeams {
  // The end that yellow defends when the log begins (recorded_ends.hpp): west is -x. nullopt:
  // unknown.
  std::optional<Side> yellow_end;
  // Robots that keep the goals although other robots are announced as keepers. -1: unknown;
  // nullopt: the announced keeper. If no keeper is ever announced for a
  // team, its robot 0 is assumed to be announced.
  PerSide<std::optional<int>> actual_keepers;
  // Stages in which both announced keepers stand at the wrong goal according to the referee's
  // packets. Each keeper does so in at least 100 frames, and nine times as often as it stands at
  // the right goal.
  TurnedStages turned;
};

// `change_ends`: whether the rule book lets the teams change ends. Throws league::LogError.
RecordedTeams teams_in(const std::filesystem::path& log, const Field& field, bool change_ends,
                       league::FrameSource source = league::FrameSource::kFirst);

}  // namespace autoref::logs
