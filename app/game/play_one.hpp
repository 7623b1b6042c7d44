// A single game and its outputs, and the flag --speed.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/network_flags.hpp"
#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"

namespace autoref::app {

// Parses a speed relative to real time, from 0.01 to 1000. Throws InputError if `text` is not such
// a speed. `others` are the other values that --speed accepts, such as "max or lockstep"; the error
// message also names them.
double speed_factor_in(const std::string& text, std::string_view others);

// Outputs of a game, as chosen by flags.
struct GameOutput {
  std::string events;       // output file for the referee's decisions; empty: none
  std::string game_events;  // output file for the decisions as game events; empty: none
  std::string chains;       // output file for the possession chains; empty: none
  std::string actions;      // output file for the actions; empty: none
  std::string
      log;  // output file for vision and referee packets (league/game_packets.hpp); empty: none
  std::string view;    // output file for the page that shows the game (view/page.hpp); empty: none
  std::string record;  // output file for the commands of team programs; empty: none
  WebFlags web;        // network address at which to show the game
  // Speed of a game that is simulated here: a factor or "max"; empty: real time if the game is
  // shown.
  std::string speed;
  bool json = false;
};

// A way to play a game other than play() (game.hpp): with programs or people on the network. Such a
// game ends when the user interrupts (is_interrupted()). It cannot be repeated, so its files appear
// as they are written, and are kept.
struct GamePlayer {
  game::TeamMaker make_network_team;
  std::function<game::PlayedGame(const game::Observers& observers, game::GamePrograms& programs)>
      play;
};

// Recorded commands to play instead of the programs. If the path is empty, the programs play.
struct RecordedCommands {
  std::filesystem::path file = {};
  io::FileKind kind = io::FileKind::kFileOrPipe;
};

// From now on, Ctrl-C, SIGTERM and SIGHUP only set a flag. A second signal, half a second after the
// first or later, ends the program immediately, in case the game hangs.
void note_interrupts();

// Whether the user has interrupted since note_interrupts(), which play_one() calls.
bool is_interrupted();

// Throws Interrupted if the user has interrupted.
void check_interrupt();

// Adds the flags of GameOutput except --speed.
void add_output_options(CLI::App& verb, GameOutput& output);

// Adds --speed.
void add_speed_option(CLI::App& verb, GameOutput& output);

// The pace that --speed and --web choose, in frames per second of wall-clock time; nullopt for as
// many as possible. Throws InputError if the value of --speed is invalid.
std::optional<double> pace_of(const game::GameConfiguration& game, const GameOutput& output);

// Plays the game to its end or, if recorded commands are played, to that of an interrupted game,
// without any output. `frames_per_s` is the pace in wall-clock time; nullopt: as fast as possible.
game::PlayedGame play_game(const game::GameConfiguration& configuration,
                           const game::Observers& observers, game::GamePrograms& programs,
                           std::optional<double> frames_per_s = std::nullopt);

// Plays the game, prints its report, and writes its decisions, its log and its page as requested.
// After Ctrl-C, throws Interrupted. A game with a `player` then has its report and all its files,
// up to that time; if the program is killed, at most the last second is missing. Of other games,
// which can be repeated, only the log remains. `inputs` are the files from which the game was read;
// they must not be overwritten. Throws InputError before the game starts if an output file is one
// of `inputs` or is also another output.
//
// Throws InputError if `commands` were recorded in another game. Commands of an interrupted game
// are played as far as they go.
game::GameRecord play_one(const game::GameConfiguration& game, const GameOutput& output,
                          const std::vector<std::string>& inputs,
                          const RecordedCommands& commands = {}, const GamePlayer& player = {});

}  // namespace autoref::app
