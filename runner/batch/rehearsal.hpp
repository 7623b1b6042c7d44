// Tries out an experiment before it is run: do its teams play, and how long will it take?
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runner/experiments/schedule.hpp"
#include "runner/game/game.hpp"

namespace autoref::runner {

// Trial games of one combination of values or one matchup.
struct Rehearsal {
  std::string played;        // prefix of the games' ids, such as "b.handicap=0.8"
  int games = 0;             // in the experiment
  std::string void_reason;   // empty unless void
  double wall_s_a_game = 0;  // estimate; 0 if void
  bool was_tried = true;     // false if there was no time; the estimate is then the others' mean
};

struct RehearsalOptions {
  std::function<GameRecord(const GameConfiguration&)> play;  // called in workers
  int workers = 1;       // as many as in the experiment, since workers share caches and processors
  double longest_s = 8;  // approximate wall-clock limit for all rehearsals together
};

// Simulated length of each half in the first rehearsal, unless the game's halves are shorter.
inline constexpr double kRehearsedHalf_s = 5;

// Wall time of a part of a game.
struct RehearsedPart {
  double share = 0;  // of the game's length
  double wall_s = 0;
};

// Estimates the wall time of a whole game. The first part is the shortest; the others have equal
// shares.
double whole_game_s(const std::vector<RehearsedPart>& parts);

// Returns one rehearsal per combination of values or matchup, in the schedule's order. Each first
// plays a few seconds, which shows whether its teams play at all; then one or more whole games if
// there is time, otherwise the longest part of a game that fits. The start of a game costs less
// than its middle, and under the 2026 rules the clock stops when play does, so only longer parts
// show how long a game takes. Throws Interrupted if the user interrupts.
std::vector<Rehearsal> rehearse(const std::vector<ScheduledGame>& games,
                                const RehearsalOptions& options);

// Estimated wall time of all games with this number of workers, in s.
double duration_s(const std::vector<Rehearsal>& rehearsals, int workers);

}  // namespace autoref::runner
