// Games that begin where a log is at some time.
#pragma once

#include <string>

#include "app/command_line.hpp"
#include "game/settings/assignments.hpp"

namespace autoref::app {

struct PlayedInstant {
  std::string log;
  double at_s = 0;  // from the start of the log
};

// Parses LOG@SECONDS. Throws InputError naming --from.
PlayedInstant instant_in(const std::string& from);

// The game of `arguments.file`, beginning where the log is at that time. Without a scenario, field
// and numbers of robots are the log's, unless they are set. Throws InputError.
game::GameSettings game_from_log(const PlayArguments& arguments,
                                 const game::Assignments& assignments);

}  // namespace autoref::app
