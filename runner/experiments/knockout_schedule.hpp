// Schedules the games of a knockout.
#pragma once

#include <vector>

#include "runner/experiments/bracket.hpp"
#include "runner/experiments/knockout.hpp"
#include "runner/experiments/schedule.hpp"

namespace autoref::runner {

// The games played if the better seed wins every tie in its first game, without replays. Throws
// std::invalid_argument if a setting is invalid.
std::vector<ScheduledGame> scheduled_games(const Knockout& knockout);

// The games known so far: those that these ties have already played, and the next game of each
// undecided tie with two known teams.
//
// In ids, rows and seeds, the tie's number replaces the pair, and the attempt replaces the leg:
// "cobalt~zone-p0007-1", and after a draw "cobalt~zone-p0007-2". The better seed is team a and
// starts in the west; in each replay the teams change ends, and the other team kicks off first. All
// games of a tie belong to the same shard.
std::vector<ScheduledGame> games_of(const Knockout& knockout, const std::vector<Tie>& ties);

}  // namespace autoref::runner
