#include "experiments/export/export_folder.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "experiments/export/game_tables.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/program_versions.hpp"
#include "game/settings/game_settings.hpp"
#include "io/checksum.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/processes/progress.hpp"
#include "io/processes/workers.hpp"

namespace autoref::experiments {
namespace {

using game::column_type::kInteger;
using game::column_type::kReal;
using game::column_type::kText;

const std::vector<SqliteColumn> kSettingsColumns = {{"setting", kText}, {"value"}};

std::vector<std::string> names_of(const std::vector<SqliteColumn>& columns) {
  std::vector<std::string> names;
  names.reserve(columns.size());
  for (const SqliteColumn& column : columns) names.push_back(column.name);
  return names;
}

// Columns of `games` with cells that are texts even if they look like numbers.
bool is_text(std::string_view column) {
  return column.ends_with("_hash") || column == "game_id" || column == "team_a" ||
         column == "team_b";
}

template <typename Number>
bool reads(std::string_view cell, Number& number) {
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  return error == std::errc() && end == cell.data() + cell.size();
}

// An empty cell becomes NULL, a cell that parses as a finite number becomes a number, and any other
// a text.
SqliteValue value_of(const std::string& cell) {
  if (cell.empty()) return {};
  std::int64_t integer = 0;
  if (reads(cell, integer)) return integer;
  double real = 0;
  if (reads(cell, real) && std::isfinite(real)) return real;
  return cell;
}

// The column type that can hold both the column's values so far and this value.
const char* widened(const char* type, const SqliteValue& value) {
  if (std::holds_alternative<std::monostate>(value)) return type;
  if (std::holds_alternative<std::string>(value) || type == kText) return kText;
  return std::holds_alternative<double>(value) || type == kReal ? kReal : kInteger;
}

void add_games(SqliteFile& file, const ResultFolder& folder) {
  const io::Cells names = folder.format.reproducible_names();
  std::vector<SqliteColumn> columns;
  for (const std::string& name : names) columns.push_back({name, is_text(name) ? kText : ""});
  columns.push_back({"build", kText});
  std::vector<SqliteRow> rows;
  for (const auto& [id, row] : folder.completed_games.done) {
    SqliteRow& values = rows.emplace_back();
    const io::Cells cells = folder.format.reproducible(row);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      values.push_back(is_text(names[i]) ? SqliteValue(cells[i]) : value_of(cells[i]));
      columns[i].type = widened(columns[i].type, values.back());
    }
    values.emplace_back(row.circumstances.build);
  }
  SqliteTable table(file, "games", columns);
  for (const SqliteRow& row : rows) table.add(row);
}

// Adds a row for each scalar below `node`. A list counts as one scalar, written as in the file.
void add_scalars(SqliteTable& table, const YAML::Node& node, const std::string& path) {
  if (node.IsMap()) {
    const std::string before = path.empty() ? "" : path + ".";
    for (const auto& member : node)
      add_scalars(table, member.second, before + member.first.as<std::string>());
    return;
  }
  if (node.IsScalar()) {
    table.add({path, value_of(node.Scalar())});
    return;
  }
  YAML::Emitter text;
  text << YAML::Flow << node;
  table.add({path, std::string(text.c_str())});
}

void add_settings(SqliteFile& file, const ResultFolder& folder) {
  SqliteTable table(file, "settings", kSettingsColumns);
  add_scalars(table, YAML::Load(effective_text(folder.scenario)), "");
}

// Replays games. What happens in them is too much for a worker's answer, so it is passed in files.
class Replays {
 public:
  Replays(const ResultFolder& folder, std::string remedy)
      : folder_(folder), remedy_(std::move(remedy)) {}

  // Called in a worker. Writes the game's tables to a file and returns the hash of its final state.
  std::string play_again(std::size_t game) const {
    const game::GameConfiguration configuration = resolved(folder_.games[game]);
    GameTables tables(folder_.games[game].id, configuration);
    game::GamePrograms programs = recorded_programs(configuration, folder_.path);
    game::GameRecord record = game::play(configuration, &tables, programs.maker());
    programs.finish(record);
    io::PendingFile(file_of(game)).commit(tables.bytes());
    return io::hash_text(record.state_hash);
  }

  // Throws InputError if the game ended differently from its row.
  void check(const io::JobResult& result) const {
    const std::string& id = folder_.games[result.job].id;
    const std::uint64_t stored = folder_.completed_games.done.at(id).record.state_hash;
    if (result.failure.empty() && result.payload == io::hash_text(stored)) return;
    const std::string why = result.failure.empty() ? "its replay ends in a different state"
                                                   : "it cannot be replayed: " + result.failure;
    throw io::InputError(
        {folder_.path.string()}, "",
        fmt::format("what happened in game {} is unknown, since {} (played by build {}); use the "
                    "build that played it{}",
                    id, why, folder_.build, remedy_));
  }

  std::string file_of(std::size_t game) const { return files_ / std::to_string(game); }

 private:
  const ResultFolder& folder_;
  std::string remedy_;
  io::WorkingFolder files_;
};

}  // namespace

std::vector<std::string> settings_columns() { return names_of(kSettingsColumns); }

std::vector<std::string> game_table_columns(const std::string& name) {
  for (const GameTable& table : game_tables())
    if (table.name == name) return names_of(table.columns);
  throw std::logic_error("no table " + name);
}

void add_game_tables(SqliteFile& file, const ResultFolder& folder,
                     const std::vector<std::size_t>& games, const ReplayOptions& options) {
  const Replays replays(folder, options.remedy);
  io::Progress bar(options.progress, {.total = static_cast<int>(games.size())});
  io::WorkerOptions pool;
  pool.workers = options.workers;
  const auto done = [&](const io::JobResult& result) {
    replays.check(result);
    bar.game_done();
  };
  const io::Ending ending =
      io::do_jobs(games, pool,
                  {[&](const io::Job& job) { return replays.play_again(job.number); }, done,
                   [&bar] { bar.tick(); }});
  if (ending == io::Ending::kInterrupted) throw io::Interrupted();
  std::vector<std::string> names;
  for (const GameTable& table : game_tables()) {
    const SqliteTable created(file, table.name, table.columns);
    names.emplace_back(table.name);
  }
  for (const std::size_t game : games) file.add_rows(names, replays.file_of(game));
}

std::string exported(const ResultFolder& folder, const std::optional<ReplayOptions>& replays) {
  SqliteFile file;
  file.execute("BEGIN");
  add_games(file, folder);
  add_settings(file, folder);
  file.execute("COMMIT");
  if (replays) add_game_tables(file, folder, folder.good_games(), *replays);
  return file.bytes();
}

}  // namespace autoref::experiments
