// Schedules the scenes of situations.
#pragma once

#include <vector>

#include "runner/experiments/schedule.hpp"
#include "runner/experiments/situations.hpp"

namespace autoref::runner {

// The games in playing order: each scene with all situations and teams before the next one, its two
// legs adjacent. In the second leg, the same start state is turned to the other side. A game
// depends only on its situation, teams, pair and leg; all teams get the same start states and
// seeds. Ids look like "corner+cobalt~possession-p0007-2". Throws std::invalid_argument if a
// setting is invalid or a state cannot be drawn.
std::vector<ScheduledGame> scheduled_games(const Situations& situations);

}  // namespace autoref::runner
