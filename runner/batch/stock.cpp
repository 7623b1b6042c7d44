#include "runner/batch/stock.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "runner/io/checksum.hpp"
#include "runner/io/errors.hpp"
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

void refuse_other_configuration(const StoredRow& row, const PlannedGame& game,
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

}  // namespace

Stock take_stock(const std::vector<StoredRow>& rows, const std::vector<PlannedGame>& games,
                 const RowFormat& format, const std::string& build, bool allow_mixed_build,
                 const std::filesystem::path& folder, const std::string& changes) {
  if (!allow_mixed_build) refuse_other_builds(rows, build, folder);
  std::map<std::string, const PlannedGame*> by_id;
  for (const PlannedGame& game : games) by_id[game.id] = &game;
  Stock stock;
  for (const StoredRow& row : rows) {
    const auto game = by_id.find(row.id);
    if (row.build != build) {
      ++stock.other_builds[row.build];
    } else if (game == by_id.end()) {
      ++stock.other_games;
    } else {
      refuse_other_configuration(row, *game->second, folder, changes);
      const auto [place, is_new] = stock.done.try_emplace(row.id, row.cells);
      if (!is_new) refuse_difference(row, place->second, format);
    }
  }
  return stock;
}

Inventory take_inventory(const Scenario& scenario, const std::vector<StoredRow>& rows,
                         const RowFormat& format, const std::string& build, bool allow_mixed_build,
                         const std::filesystem::path& folder, const std::string& changes) {
  Inventory inventory{course_of(scenario, format, {}), {}};
  while (true) {
    inventory.stock =
        take_stock(rows, inventory.course.games, format, build, allow_mixed_build, folder, changes);
    if (!follows_its_rows(scenario)) return inventory;
    const std::size_t known = inventory.course.games.size();
    inventory.course = course_of(scenario, format, inventory.stock.done);
    if (inventory.course.games.size() == known) return inventory;  // else more rows belong to it
  }
}

}  // namespace autoref::runner
