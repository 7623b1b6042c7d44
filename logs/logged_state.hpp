// The state of a recorded game at one time, for games that begin with it.
#pragma once

#include <filesystem>

#include "game/loop/start_scene.hpp"
#include "league/log_contents.hpp"
#include "soccer/field.hpp"

namespace autoref::logs {

struct LoggedState {
  // The start state. Yellow is in the west, whichever end it defends in the log. Positions and
  // velocities come from the tracker (tracking/tracker.hpp). The ball's vertical velocity is
  // unknown and assumed to be zero. The restart is the one that was pending. If the command was
  // HALT, STOP or the like, it is the restart that the packet announces. If the packet announces
  // none, it is the next restart in the log, or a force start if there is none. The signal is the
  // last one; it names the robots that keep the goals as keepers (recorded_teams.hpp).
  game::StartState start;
  league::LogSummary log;
};

// The state of the last frame at or before `at_s`, in seconds from the start of the log. Throws
// std::invalid_argument if the file is not a log, if the log does not cover that time, or if there
// is no ball at that time.
LoggedState logged_state(const std::filesystem::path& log, double at_s);

// Gives the side's robots numbers below `count`, in the same order, unless they already have such
// numbers. The keeper that the packets name gets the number that teams use for their keepers by
// default, TeamRequests::keeper, in exchange for its own. Robots that are not on the field at the
// start disappear from what was seen before and from the ghost. Throws std::invalid_argument if
// there are more than `count` robots.
void renumber(game::StartState& start, Side side, int count);

// Throws std::invalid_argument if the log's field differs from the field of the game.
void check_same_field(const LoggedState& logged, const Field& field);

}  // namespace autoref::logs
