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

// In how many frames each robot of a side is nearest to its own goal.
struct GoalDuty {
  std::array<int, kMaxRobots> nearest{};
  int all = 0;  // frames with any robot of the side
};

// The robot that actually keeps the goal if positions contradict the announced keeper, that is, if
// over at least 100 frames the announced keeper is hardly ever nearest to its own goal. This is the
// robot that is nearest most of the time, or -1 if there is none.
std::optional<int> actual_keeper(const GoalDuty& duty, int announced);

struct RecordedTeams {
  // The end that yellow defends when the log begins (recorded_ends.hpp): west is -x. nullopt:
  // unknown.
  std::optional<Side> yellow_end;
  // Robots that keep the goals although others are announced; -1: unknown; nullopt: the announced
  // keeper. If no keeper is ever announced, robot 0 is assumed.
  PerSide<std::optional<int>> actual_keepers;
  // Stages in which both announced keepers stand in front of the goal opposite to the one given by
  // the referee's packets, in at least 100 frames each and nine times as often as in front of the
  // given one.
  TurnedStages turned;
};

// `change_ends`: whether the rule book lets the teams change ends. Throws league::LogError.
RecordedTeams teams_in(const std::filesystem::path& log, const Field& field, bool change_ends,
                       league::FrameSource source = league::FrameSource::kFirst);

}  // namespace autoref::logs
