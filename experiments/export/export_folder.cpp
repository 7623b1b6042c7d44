#include "experiments/export/export_folder.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "experiments/export/sqlite_file.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/program_versions.hpp"
#include "game/loop/event_log.hpp"
#include "game/settings/game_settings.hpp"
#include "io/checksum.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/json.hpp"
#include "io/processes/progress.hpp"
#include "io/processes/workers.hpp"

namespace autoref::experiments {
namespace {

using Row = std::vector<SqliteValue>;

using game::column_type::kInteger;
using game::column_type::kReal;
using game::column_type::kText;

constexpr const char* kEvents = "events";

const std::vector<SqliteColumn> kSettingsColumns = {{"setting", kText}, {"value"}};

std::vector<SqliteColumn> columns_of_events() {
  std::vector<SqliteColumn> columns = {{"game_id", kText}, {"number", kInteger}};
  for (const game::DecisionField& field : game::decision_fields())
    if (field.has_column()) columns.push_back({game::column_of(field), field.type});
  return columns;
}

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

SqliteValue value_of(double real) {
  return std::isfinite(real) ? SqliteValue(real) : SqliteValue();
}

SqliteValue value_of(const io::Json& json) {
  if (json.is_null() || json.is_discarded()) return {};
  if (json.is_boolean()) return std::int64_t{json.get<bool>()};
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return value_of(json.get<double>());
  if (json.is_string()) return json.get<std::string>();
  return io::json_text(json);
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
  std::vector<Row> rows;
  for (const auto& [id, row] : folder.completed_games.done) {
    Row& values = rows.emplace_back();
    const io::Cells cells = folder.format.reproducible(row);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      values.push_back(is_text(names[i]) ? SqliteValue(cells[i]) : value_of(cells[i]));
      columns[i].type = widened(columns[i].type, values.back());
    }
    values.emplace_back(row.circumstances.build);
  }
  SqliteTable table(file, "games", columns);
  for (const Row& row : rows) table.add(row);
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

std::vector<std::size_t> games_with_events(const ResultFolder& folder) {
  std::vector<std::size_t> games;
  for (std::size_t i = 0; i < folder.games.size(); ++i) {
    const auto row = folder.completed_games.done.find(folder.games[i].id);
    if (row != folder.completed_games.done.end() && row->second.record.status == game::Status::kOk)
      games.push_back(i);
  }
  return games;
}

// The event rows of one game, in a separate database.
class DecisionRows final : public game::Observer {
 public:
  DecisionRows(std::string id, const game::EventGame& events)
      : id_(std::move(id)), events_(events) {
    file_.execute("BEGIN");
  }

  void on_decision(const referee::Decision& decision) override {
    Row row = {id_, ++number_};
    for (const game::DecisionField& field : game::decision_fields())
      if (field.has_column()) row.push_back(value_of(field.value(decision, events_)));
    table_.add(row);
  }

  // Call this after the game.
  std::string bytes() {
    file_.execute("COMMIT");
    return file_.bytes();
  }

 private:
  std::string id_;
  game::EventGame events_;
  std::int64_t number_ = 0;
  SqliteFile file_;
  SqliteTable table_{file_, kEvents, columns_of_events()};
};

// Replays games. Their events are too many for a worker's answer, so they are passed in files.
class Replays {
 public:
  explicit Replays(const ResultFolder& folder) : folder_(folder) {}

  // Called in a worker. Writes the game's events to a file and returns the hash of its final state.
  std::string play_again(std::size_t game) const {
    const game::GameConfiguration configuration = resolved(folder_.games[game]);
    DecisionRows events(folder_.games[game].id, game::event_game_of(configuration));
    game::GamePrograms programs = recorded_programs(configuration, folder_.path);
    game::GameRecord record = game::play(configuration, &events, programs.maker());
    programs.finish(record);
    io::PendingFile(file_of(game)).commit(events.bytes());
    return io::hash_text(record.state_hash);
  }

  // Throws InputError if the game ended differently from its row.
  void check(const io::JobResult& result) const {
    const std::string& id = folder_.games[result.job].id;
    const std::uint64_t stored = folder_.completed_games.done.at(id).record.state_hash;
    if (result.failure.empty() && result.payload == io::hash_text(stored)) return;
    const std::string why =
        result.failure.empty() ? "it ends in a different state" : result.failure;
    throw io::InputError(
        {folder_.path.string()}, "",
        fmt::format("the events of game {} are unknown, because replaying it gives another game "
                    "({}; played by build {}); leave them out with --no-events",
                    id, why, folder_.build));
  }

  std::string file_of(std::size_t game) const { return files_ / std::to_string(game); }

 private:
  const ResultFolder& folder_;
  io::WorkingFolder files_;
};

void add_events(SqliteFile& file, const ResultFolder& folder, const ExportOptions& options) {
  const std::vector<std::size_t> games = games_with_events(folder);
  const Replays replays(folder);
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
  const SqliteTable table(file, kEvents, columns_of_events());
  for (const std::size_t game : games) file.add_rows(kEvents, replays.file_of(game));
}

}  // namespace

std::vector<std::string> settings_columns() { return names_of(kSettingsColumns); }

std::vector<std::string> events_columns() { return names_of(columns_of_events()); }

std::string exported(const ResultFolder& folder, const ExportOptions& options) {
  SqliteFile file;
  file.execute("BEGIN");
  add_games(file, folder);
  add_settings(file, folder);
  file.execute("COMMIT");
  if (options.has_events) add_events(file, folder, options);
  return file.bytes();
}

}  // namespace autoref::experiments
