// One game for people to look at, as `play` and `replay` print it.
#pragma once

#include <string>

#include "runner/game.hpp"

namespace autoref::runner {

struct GameOutput {
  std::string events;  // file for the referee's decisions; empty: none
  bool json = false;
  std::string source;  // the file that the game comes from, which must not be written over
};

// Plays the game, prints its report, and writes its decisions. Ctrl-C ends it: then, Interrupted is
// thrown and nothing is written.
GameRecord play_one(const GameConfiguration& game, const GameOutput& output);

}  // namespace autoref::runner
