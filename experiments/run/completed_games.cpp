#include "experiments/run/completed_games.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "experiments/results/game_row.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "io/processes/workers.hpp"

namespace autoref::experiments {
namespace {

void refuse_other_builds(const RowsInFiles& rows, const std::string& build,
                         const std::filesystem::path& folder) {
  for (const auto& [id, row] : rows) {
    if (row.circumstances.build == build) continue;
    throw io::InputError(
        {folder.string()}, "",
        fmt::format("holds games of build {}, but this is build {}; choose another "
                    "folder with -o, or mix builds with --allow-mixed-build",
                    row.circumstances.build, build));
  }
}

void refuse_other_configuration(const GameRow& row, const ScheduledGame& game,
                                const std::filesystem::path& folder, const std::string& changes) {
  if (row.config_hash == game::configuration_hash(game.settings.combined())) return;
  throw io::InputError(
      {folder.string()}, "",
      fmt::format(
          "holds game {} with a different configuration ({}); choose another folder with -o",
          row.game_id, changes.empty() ? "differences unknown" : changes));
}

void refuse_difference(const GameRow& first, const GameRow& second, const RowFormat& format) {
  const std::optional<ColumnDifference> difference = format.first_difference(first, second);
  if (!difference) return;
  throw std::logic_error(fmt::format(
      "nondeterminism: game {} has two rows of the same build; {} is {} in one and {} in the other",
      first.game_id, difference->column, difference->first, difference->second));
}

// Handles a second row of a game. Killed games are replayed, so the row of a killed game is
// replaced.
void add_another(GameRow row, const RowFormat& format, GameRow& kept) {
  if (is_killed(kept)) {
    kept = std::move(row);
  } else if (!is_killed(row)) {
    refuse_difference(kept, row, format);
  }
}

// The rows of a build, whether or not they belong to scheduled games.
RowsById rows_of_build(const RowsInFiles& rows, const std::string& build) {
  RowsById by_id;
  for (const auto& [id, row] : rows) {
    if (row.circumstances.build != build) continue;
    const auto [entry, is_new] = by_id.try_emplace(id, row);
    if (!is_new && is_killed(entry->second)) entry->second = row;
  }
  return by_id;
}

}  // namespace

bool is_killed(const GameRow& row) {
  return is_void(row.record) && io::was_killed(row.record.void_reason);
}

CompletedGames sort_rows(RowsInFiles rows, const std::vector<ScheduledGame>& games,
                         const RowFormat& format, const std::string& build, bool allow_mixed_build,
                         const std::filesystem::path& folder, const std::string& changes) {
  if (!allow_mixed_build) refuse_other_builds(rows, build, folder);
  std::map<std::string_view, const ScheduledGame*> by_id;
  for (const ScheduledGame& game : games) by_id[game.id] = &game;
  CompletedGames completed_games;
  while (!rows.empty()) {
    RowsInFiles::node_type node = rows.extract(rows.begin());
    GameRow& row = node.mapped();
    const auto game = by_id.find(row.game_id);
    if (row.circumstances.build != build) {
      ++completed_games.other_builds[row.circumstances.build];
    } else if (game == by_id.end()) {
      ++completed_games.other_games;
    } else {
      refuse_other_configuration(row, *game->second, folder, changes);
      const auto inserted = completed_games.done.insert(std::move(node));
      if (!inserted.inserted)
        add_another(std::move(inserted.node.mapped()), format, inserted.position->second);
    }
  }
  return completed_games;
}

RowInventory take_row_inventory(const Scenario& scenario, RowsInFiles rows, const RowFormat& format,
                                const std::string& build, bool allow_mixed_build,
                                const std::filesystem::path& folder, const std::string& changes) {
  const auto sorted = [&](RowsInFiles its, const Schedule& schedule) {
    return sort_rows(std::move(its), schedule.games, format, build, allow_mixed_build, folder,
                     changes);
  };
  if (!scenario.experiment().follows_its_rows()) {
    RowInventory row_inventory{scenario.experiment().schedule({}), {}};
    row_inventory.completed_games = sorted(std::move(rows), row_inventory.schedule);
    return row_inventory;
  }
  // Start from the rows as they are: if they belong to the scenario, one iteration is enough. If
  // they do not, sort_rows() refuses the rows on which the schedule depends.
  RowInventory row_inventory{scenario.experiment().schedule(rows_of_build(rows, build)), {}};
  // Iterate to a fixed point: rows can extend a schedule (a knockout's, for example), and a longer
  // schedule can claim more rows.
  while (true) {
    row_inventory.completed_games = sorted(rows, row_inventory.schedule);
    const std::size_t known = row_inventory.schedule.games.size();
    row_inventory.schedule = scenario.experiment().schedule(row_inventory.completed_games.done);
    if (row_inventory.schedule.games.size() == known)
      return row_inventory;  // otherwise repeat: more rows may belong to the longer schedule
  }
}

}  // namespace autoref::experiments
