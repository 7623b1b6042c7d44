// The programs of teams in an experiment: the files they leave in its folder, and their versions,
// which are identified by the content of the programs' files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"

namespace autoref::experiments {

// The programs of an experiment's games leave two things in its folder: their commands, which allow
// the games to be replayed without the programs, and their output on standard error.

// To see whether the programs of a game send the same commands again, a run restarts them and
// replays this many seconds from the start of the game.
inline constexpr double kRepeated_s = 10;

// commands/GAME_ID.gz
std::filesystem::path commands_file(const std::filesystem::path& folder, const std::string& id);

// Copies the files that the programs of a game left in one folder to another. Files that are
// missing are left out. Throws InputOutputError.
void copy_program_files(const std::filesystem::path& from, const std::filesystem::path& to,
                        const std::string& id);

// Plays a game of the folder with its programs, stores the files that they leave, and finds out
// whether the programs repeat their commands. `play` plays the game and returns its record, which
// this function completes. If a program is killed from outside, `play` is called again, up to five
// times.
void play_live(const game::GameConfiguration& game, const std::filesystem::path& folder,
               const std::function<game::GameRecord&(game::GamePrograms&)>& play);

// The programs for replaying a game of the folder, from the recorded commands if there are any.
game::GamePrograms recorded_programs(const game::GameConfiguration& game,
                                     const std::filesystem::path& folder);

// Plays a game of the folder with its programs, or from the recorded commands. Throws whatever
// play() and the programs' files throw.
game::GameRecord play_live(const game::GameConfiguration& game,
                           const std::filesystem::path& folder);
game::GameRecord play_recorded(const game::GameConfiguration& game,
                               const std::filesystem::path& folder);

// Stores a hash of the program's files in every team that has a program with known files
// (TeamSettings::files_hash), so that games with another version of the program are different
// games. The files are those named by the setting `files`, including everything in its folders
// except hidden files and Python's __pycache__; without that setting, they are the words of the
// command that are files. Relative paths are relative to the program's working directory. A program
// found in PATH is not included. If a factor varies the program, each of its values is assigned the
// files of all values. Throws InputError if a file is missing or cannot be read, or if there are
// more than 10,000 files or more than 1 GiB.
void note_program_versions(Scenario& scenario);

// Detects changes in the content of programs' files. A file with unchanged time and size is assumed
// to be unchanged.
class ProgramChanges {
 public:
  explicit ProgramChanges(const Scenario& scenario);

  // The paths of the settings, such as "teams.mine.files", whose programs have changed since this
  // object was created.
  std::vector<std::string> changed_settings();

 private:
  struct Watched {
    std::filesystem::path file;
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Watched&) const = default;
  };
  struct WatchedProgram {
    std::string path;                          // path of the team's settings
    std::vector<game::TeamSettings> variants;  // one for each value of a factor
    std::vector<Watched> files;
  };
  static std::vector<Watched> look_at(const WatchedProgram& program);

  std::vector<WatchedProgram> programs_;
};

}  // namespace autoref::experiments
