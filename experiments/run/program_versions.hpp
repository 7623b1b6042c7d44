// Teams' programs in an experiment: what they leave in its folder, and their versions by the
// content of their files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"

namespace autoref::experiments {

// What the programs of an experiment's games leave in its folder: their commands, with which the
// games can be played again without them, and what they wrote to standard error.

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

// Notes in every team whose program consists of known files what these contain now, so that games
// of another version of the program are other games (TeamSettings::files_hash). The files are those
// that the setting `files` names, with what is below its folders except hidden files and Python's
// __pycache__, or else the words of the command that are files; relative paths begin in the
// program's directory. A program that is found in PATH is not looked at. The levels of a factor
// share the files of all of them. Throws InputError if a file is missing or cannot be read, or if
// there are more than 10,000 files or more than 1 GiB.
void note_program_versions(Scenario& scenario);

// Notices whether what a program's files contain is changed. A file that has kept its time and size
// is taken to be the same.
class ProgramChanges {
 public:
  explicit ProgramChanges(const Scenario& scenario);

  // The settings, such as "teams.mine.files", of the programs that are not as they were when this
  // object was made.
  std::vector<std::string> changed_settings();

 private:
  struct Watched {
    std::filesystem::path file;
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Watched&) const = default;
  };
  struct WatchedProgram {
    std::string path;                          // of the team's settings
    std::vector<game::TeamSettings> variants;  // one for each value of a factor
    std::vector<Watched> files;
  };
  static std::vector<Watched> look_at(const WatchedProgram& program);

  std::vector<WatchedProgram> programs_;
};

}  // namespace autoref::experiments
