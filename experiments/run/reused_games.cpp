#include "experiments/run/reused_games.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>

#include "experiments/results/game_row.hpp"
#include "experiments/results/shard.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

bool have_known_content(const ScheduledGame& game) {
  return has_known_content(game.settings.a()) && has_known_content(game.settings.b());
}

// Whether the row belongs to this game. The hash covers all settings and the content of the
// programs' files, if these are known.
bool is_row_of(const GameRow& row, const ScheduledGame& game) {
  return row.pair == game.pair && row.leg == game.leg && row.team_a == game.team_a &&
         row.team_b == game.team_b && row.seed == game.settings.leg().seed &&
         row.config_hash == game::configuration_hash(game.settings.combined());
}

bool is_repeated(const GameRow& row) {
  return !is_void(row.record) && row.record.is_repeatable.value_or(true);
}

// "40 of 60 games are taken over from FOLDER"; says what to do about programs with unknown files.
std::string note_on(const fs::path& folder, std::size_t taken, std::size_t rows,
                    std::size_t unknown) {
  std::string note =
      fmt::format("{} of {} games are taken over from {}", taken, rows, folder.string());
  if (unknown > 0) {
    note += fmt::format(
        "; {} are not, because the files of a program are unknown: list them in its setting files, "
        "such as --set old.files=FOLDER",
        unknown);
  }
  return note;
}

ReusableGames reusable_rows(const RowsInFiles& rows, const fs::path& folder,
                            const std::vector<ScheduledGame>& games, const std::string& build) {
  std::map<std::string_view, const ScheduledGame*> wanted;
  for (const ScheduledGame& game : games) wanted[game.id] = &game;
  ReusableGames reusable;
  std::size_t unknown = 0;
  const std::size_t count = rows.size();
  for (const auto& [id, row] : rows) {
    const auto game = wanted.find(id);
    if (game == wanted.end() || row.circumstances.build != build) continue;
    if (!is_repeated(row) || !is_row_of(row, *game->second)) continue;
    if (!have_known_content(*game->second)) {
      ++unknown;
      continue;
    }
    reusable.rows.push_back(row);
    wanted.erase(game);
  }
  reusable.note = note_on(folder, reusable.rows.size(), count, unknown);
  return reusable;
}

}  // namespace

bool has_known_content(const game::TeamSettings& team) {
  return team.program.command.empty() || !team.files_hash.empty();
}

ReusableGames reusable_games(const fs::path& folder, const std::vector<ScheduledGame>& games,
                             const RowFormat& format, const std::string& build) {
  std::error_code none;
  if (!fs::exists(folder, none))
    return {{}, fmt::format("{} does not exist yet; all games are played", folder.string())};
  if (!fs::is_directory(folder, none))
    throw io::InputError({folder.string()}, "", "expected a results folder to take games from");
  if (!fs::is_directory(folder / kGamesFolder, none))
    return {{}, fmt::format("{} holds no games; all games are played", folder.string())};
  try {
    return reusable_rows(read_rows(folder / kGamesFolder, format).rows, folder, games, build);
  } catch (const io::InputError& error) {
    return {{}, fmt::format("no game is taken over: {}", error.what())};
  }
}

}  // namespace autoref::experiments
