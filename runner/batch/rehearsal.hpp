// A look at an experiment before it is run: do its teams play, and how long will it take?
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runner/experiments/schedule.hpp"
#include "runner/game/game.hpp"

namespace autoref::runner {

// Games that stand for all that differ from them in pair and leg only.
struct Rehearsal {
  std::string played;  // what the games' ids begin with, such as "b.handicap=0.8"
  int games = 0;
  std::string void_reason;   // empty where it went well
  double wall_s_a_game = 0;  // about; 0 where it went wrong
  bool was_tried = true;     // else there was no time, and the others' mean stands for it
};

struct RehearsalOptions {
  std::function<GameRecord(const GameConfiguration&)> play;  // called in workers
  int workers = 1;       // as many as the experiment is to have: they share caches and processors
  double longest_s = 8;  // of all rehearsals together, about
};

// Simulated seconds of each half of the first rehearsal, of games that are not shorter.
inline constexpr double kRehearsedHalf_s = 5;

// One for each combination of values or matchup, in the plan's order. Each plays a few seconds
// first, which shows whether it plays at all; then a whole game or several where there is time,
// or else the longest part of one that fits. The start of a game costs less than its middle, and by
// the rules of 2026 the clock stands while play is stopped, so only longer parts show what a game
// takes. Throws Interrupted where the user does.
std::vector<Rehearsal> rehearse(const std::vector<ScheduledGame>& games,
                                const RehearsalOptions& options);

// Wall seconds of all the games, so many at a time.
double duration_s(const std::vector<Rehearsal>& rehearsals, int workers);

}  // namespace autoref::runner
