// A look at an experiment before it is run: do its teams play, and how long will it take?
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runner/experiments/schedule.hpp"
#include "runner/game/game.hpp"

namespace autoref::runner {

// A few seconds of one game, standing for all that differ from it in pair and leg only.
struct Rehearsal {
  std::string played;  // what the games' ids begin with, such as "b.handicap=0.8"
  int games = 0;
  std::string void_reason;   // empty where it went well
  double wall_s_a_game = 0;  // about, by the seconds played; 0 where it went wrong
};

// Simulated seconds of each half that a rehearsal plays, of games that are not shorter.
inline constexpr double kRehearsedHalf_s = 5;

// One for each combination of values or matchup, in the plan's order. `play` is called once for
// each, with the first game's configuration but short halves.
std::vector<Rehearsal> rehearse(const std::vector<ScheduledGame>& games,
                                const std::function<GameRecord(const GameConfiguration&)>& play);

// Wall seconds of all the games, so many at a time.
double duration_s(const std::vector<Rehearsal>& rehearsals, int workers);

}  // namespace autoref::runner
