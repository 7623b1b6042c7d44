// Plays a game that the league's game controller commands.
#pragma once

#include <string>
#include <vector>

#include "app/command_line.hpp"

namespace autoref::app {

// The game controller at "HOST" or "HOST:PORT", with `port` unless the text has one. Throws
// InputError naming --game-controller.
live::Address controller_address(const std::string& text, int port);

// As play_one(); says on stderr what the controller decided otherwise than AutoRef.
game::GameRecord play_controlled(const game::GameConfiguration& game,
                                 const PlayArguments& arguments,
                                 const std::vector<std::string>& inputs);

}  // namespace autoref::app
