// Games of an earlier experiment that need not be played again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/results/row_format.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

// Whether the settings identify the team: it has no program, or the files of its program are known
// (note_program_versions()).
bool has_known_content(const game::TeamSettings& team);

struct ReusableGames {
  std::vector<GameRow> rows;  // at most one per game
  std::string note;           // one line: how many games are taken over, and why not the others
};

// The rows of another results folder that equal those that playing `games` would give: the same
// game, seed, settings, build, and content of the programs' files. Not taken over are
//
//   - void games, whose cause may have gone;
//   - games of a program whose files are unknown (note_program_versions()), or that did not repeat
//     its commands.
//
// A folder that does not exist or whose rows have other columns has none; the note says so. Throws
// InputError if the path leads to something other than a folder.
ReusableGames reusable_games(const std::filesystem::path& folder,
                             const std::vector<ScheduledGame>& games, const RowFormat& format,
                             const std::string& build);

}  // namespace autoref::experiments
