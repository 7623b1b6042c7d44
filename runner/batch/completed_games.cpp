#include "runner/batch/completed_games.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "runner/io/checksum.hpp"
#include "runner/io/errors.hpp"
#include "runner/processes/workers.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

void refuse_other_builds(const std::vector<StoredRow>& rows, const std::string& build,
                         const std::filesystem::path& folder) {
  for (const StoredRow& row : rows) {
    if (row.build == build) continue;
    throw InputError({folder.string()}, "",
                     fmt::format("holds games of build {}, this is {}; choose another folder with "
                                 "-o, or keep both apart with --allow-mixed-build",
                                 row.build, build));
  }
}

void refuse_other_configuration(const StoredRow& row, const ScheduledGame& game,
                                const std::filesystem::path& folder, const std::string& changes) {
  if (row.config_hash == hash_text(configuration_hash(game.configuration))) return;
  throw InputError({folder.string()}, "",
                   fmt::format("holds the game {} with another configuration ({}); choose another "
                               "folder with -o",
                               row.id, changes.empty() ? "which is not known" : changes));
}

void refuse_difference(const StoredRow& row, const Cells& first, const RowFormat& format) {
  for (std::size_t i = 0; i < format.reproducible(first).size(); ++i) {
    if (row.cells[i] == first[i]) continue;
    throw std::logic_error(fmt::format(
        "nondeterminism: the game {} has two rows of the same build; {} is {} in one and {} in the "
        "other",
        row.id, format.columns()[i], first[i], row.cells[i]));
  }
}

// A game whose worker was killed is played again: then its other row counts, or the last of them.
void add_another(const StoredRow& row, const RowFormat& format, Cells& cells) {
  if (is_killed(cells, format)) {
    cells = row.cells;
  } else if (!is_killed(row.cells, format)) {
    refuse_difference(row, cells, format);
  }
}

}  // namespace

bool is_killed(const Cells& row, const RowFormat& format) {
  return row[format.column("status")] == name_of(Status::kVoid) &&
         was_killed(row[format.column("void_reason")]);
}

CompletedGames sort_rows(const std::vector<StoredRow>& rows,
                         const std::vector<ScheduledGame>& games, const RowFormat& format,
                         const std::string& build, bool allow_mixed_build,
                         const std::filesystem::path& folder, const std::string& changes) {
  if (!allow_mixed_build) refuse_other_builds(rows, build, folder);
  std::map<std::string, const ScheduledGame*> by_id;
  for (const ScheduledGame& game : games) by_id[game.id] = &game;
  CompletedGames completed_games;
  for (const StoredRow& row : rows) {
    const auto game = by_id.find(row.id);
    if (row.build != build) {
      ++completed_games.other_builds[row.build];
    } else if (game == by_id.end()) {
      ++completed_games.other_games;
    } else {
      refuse_other_configuration(row, *game->second, folder, changes);
      const auto [entry, is_new] = completed_games.done.try_emplace(row.id, row.cells);
      if (!is_new) add_another(row, format, entry->second);
    }
  }
  return completed_games;
}

RowInventory take_row_inventory(const Scenario& scenario, const std::vector<StoredRow>& rows,
                                const RowFormat& format, const std::string& build,
                                bool allow_mixed_build, const std::filesystem::path& folder,
                                const std::string& changes) {
  RowInventory row_inventory{schedule_of(scenario, format, {}), {}};
  while (true) {
    row_inventory.completed_games = sort_rows(rows, row_inventory.schedule.games, format, build,
                                              allow_mixed_build, folder, changes);
    if (!follows_its_rows(scenario)) return row_inventory;
    const std::size_t known = row_inventory.schedule.games.size();
    row_inventory.schedule = schedule_of(scenario, format, row_inventory.completed_games.done);
    if (row_inventory.schedule.games.size() == known)
      return row_inventory;  // else more rows belong to it
  }
}

}  // namespace autoref::runner
