// From a knockout to its list of games.
#pragma once

#include <vector>

#include "runner/experiments/bracket.hpp"
#include "runner/experiments/knockout.hpp"
#include "runner/experiments/schedule.hpp"

namespace autoref::runner {

// The games that it comes to where the better seed wins each tie at once: as many as there are,
// were none played again. Throws std::invalid_argument where a setting is wrong.
std::vector<ScheduledGame> scheduled_games(const Knockout& knockout);

// The games that are known by these ties: those that are played, and the next one of each tie whose
// teams are known and that is not decided.
//
// In ids, rows and seeds the tie's number stands where other experiments have the pair's, and how
// many times it is played where they have the leg: "cobalt~zone-p0007-1", then
// "cobalt~zone-p0007-2" after a draw. The better seed is team a; it plays in the west first, and
// each further time both change ends, and with them the first kick-off. All games of a tie go to
// the same shard.
std::vector<ScheduledGame> games_of(const Knockout& knockout, const std::vector<Tie>& ties);

}  // namespace autoref::runner
