// The state of a recorded game at one time, for games that begin with it.
#pragma once

#include <filesystem>

#include "game/loop/start_scene.hpp"
#include "league/log_contents.hpp"
#include "soccer/field.hpp"

namespace autoref::logs {

struct LoggedState {
  // Yellow is in the west, whichever end it defends in the log. Positions and velocities come from
  // the tracker (tracking/tracker.hpp); the ball's vertical velocity is unknown and assumed to be
  // 0. The restart is the one that was pending. After HALT, STOP and the like, it is the restart
  // that the packet announces, or else the next one in the log, or else a force start.
  game::StartState start;
  league::LogSummary log;
};

// The state of the last frame at or before `at_s`, in seconds from the start of the log. Throws
// std::invalid_argument if the file is not a log, or does not cover that time, or has no ball then.
LoggedState logged_state(const std::filesystem::path& log, double at_s);

// Gives the robots numbers below `count`, in the same order, unless they already have such numbers.
// Throws std::invalid_argument if there are more than `count` robots.
void renumber(game::StartingRobots& robots, int count);

// Throws std::invalid_argument if the log's field is not the game's.
void check_same_field(const LoggedState& logged, const Field& field);

}  // namespace autoref::logs
