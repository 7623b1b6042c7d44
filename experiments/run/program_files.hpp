// What the programs of an experiment's games leave in its folder: their commands, with which the
// games can be played again without them, and what they wrote to standard error.
#pragma once

#include <filesystem>
#include <functional>

#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"

namespace autoref::experiments {

// A run starts the programs of a game again and plays these first seconds again, to see whether
// they send the same commands.
inline constexpr double kRepeated_s = 10;

// commands/GAME_ID.gz
std::filesystem::path commands_file(const std::filesystem::path& folder, const std::string& id);

// Plays a game of the folder with its programs, which leave their files, and finds out whether they
// are repeatable. `play` plays the game and returns its record, which is completed here. It is
// called again, up to five times, if a program was killed from outside.
void play_live(const game::GameConfiguration& game, const std::filesystem::path& folder,
               const std::function<game::GameRecord&(game::GamePrograms&)>& play);

// Plays a game of the folder again, from the recorded commands if there are any.
game::GamePrograms recorded_programs(const game::GameConfiguration& game,
                                     const std::filesystem::path& folder);

// Plays a game with these programs. Throws what play() and the programs' files throw.
game::GameRecord play_live(const game::GameConfiguration& game,
                           const std::filesystem::path& folder);
game::GameRecord play_recorded(const game::GameConfiguration& game,
                               const std::filesystem::path& folder);

}  // namespace autoref::experiments
