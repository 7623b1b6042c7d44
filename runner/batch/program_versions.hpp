// Which version of a team's program plays: the files that it consists of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

// Notes in every team whose program consists of known files what these contain now, so that games
// of another version of the program are other games (TeamSettings::files_hash). The files are those
// that the setting `files` names, with everything below its folders, or else the words of the
// command that are files; relative paths begin in the program's directory. A program that is found
// in PATH is not looked at. Throws InputError if a file is missing or cannot be read, or if there
// are more than 10,000 files or more than 1 GiB.
void note_program_versions(Scenario& scenario);

// Notices whether a file of the programs is changed, by its time and size.
class ProgramWatch {
 public:
  explicit ProgramWatch(const Scenario& scenario);

  // The files that are not as they were when this object was made.
  std::vector<std::string> changed() const;

 private:
  struct Watched {
    std::filesystem::path file;
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Watched&) const = default;
  };
  static Watched look_at(const std::filesystem::path& file);

  std::vector<Watched> files_;
};

}  // namespace autoref::runner
