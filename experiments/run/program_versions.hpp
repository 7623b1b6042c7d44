// The versions of teams' programs, by the content of their files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"

namespace autoref::experiments {

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
class ProgramWatch {
 public:
  explicit ProgramWatch(const Scenario& scenario);

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
