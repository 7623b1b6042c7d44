// One game for people to look at, as `play` and `replay` print it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "runner/game/game.hpp"

namespace autoref::runner {

// What is made of it, as flags tell.
struct GameOutput {
  std::string events;  // file for the referee's decisions; empty: none
  std::string log;     // file for what cameras and referee send (league/game_log.hpp); empty: none
  std::string view;    // file for the page that shows it (view/page.hpp); empty: none
  bool json = false;
};

// The flags of GameOutput.
void add_output_options(CLI::App& verb, GameOutput& output);

// Plays the game, prints its report, and writes its decisions and its page. Ctrl-C ends it: then,
// Interrupted is thrown, neither is written, and the log holds the game so far.
// `inputs` are the files that the game comes from, which must not be written over. Throws
// InputError before the game where an output is one of these, or the same file as another.
GameRecord play_one(const GameConfiguration& game, const GameOutput& output,
                    const std::vector<std::string>& inputs);

}  // namespace autoref::runner
