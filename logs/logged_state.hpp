// The state of a recorded game at one time, for games that begin there.
#pragma once

#include <filesystem>

#include "game/loop/start_scene.hpp"
#include "league/log_contents.hpp"
#include "soccer/field.hpp"

namespace autoref::logs {

struct LoggedState {
  // Yellow is in the west, whichever end it defends in the log. Positions and velocities are the
  // tracker's (tracking/tracker.hpp); the ball's vertical velocity is unknown and taken to be 0.
  // The restart is the one that was pending; after HALT, STOP and the like it is the one that
  // the packet announces or, if it does not, the next one in the log, or else a force start.
  game::StartState start;
  league::LogSummary log;
};

// The state of the last frame at or before `at_s`, in seconds from the start of the log. Throws
// std::invalid_argument if the file is not a log, or does not cover that time, or has no ball then.
LoggedState logged_state(const std::filesystem::path& log, double at_s);

// Gives the robots numbers below `count`, in the same order, unless they have such numbers already.
// Throws std::invalid_argument if there are more robots than that.
void renumber(game::StartingRobots& robots, int count);

// Throws std::invalid_argument if the log's field is not that of the game.
void check_same_field(const LoggedState& logged, const Field& field);

}  // namespace autoref::logs
