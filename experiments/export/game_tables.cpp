#include "experiments/export/game_tables.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>

namespace autoref::experiments {
namespace {

// Positions in game_tables().
enum : std::size_t { kEvents, kChains, kActions, kShots };

constexpr const char* kGameId = "game_id";  // the first column of each table

SqliteValue sqlite_value(const std::optional<double>& real) {
  return real && std::isfinite(*real) ? SqliteValue(*real) : SqliteValue();
}
SqliteValue sqlite_value(int integer) { return std::int64_t{integer}; }
SqliteValue sqlite_value(const std::string& text) {
  return text.empty() ? SqliteValue() : SqliteValue(text);
}
SqliteValue sqlite_value(const io::ColumnValue& value) {
  return std::visit([](const auto& content) { return sqlite_value(content); }, value);
}

SqliteValue sqlite_value(const io::Json& json) {
  if (json.is_null() || json.is_discarded()) return {};
  if (json.is_boolean()) return std::int64_t{json.get<bool>()};
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return sqlite_value(std::optional(json.get<double>()));
  if (json.is_string()) return json.get<std::string>();
  return io::json_text(json);
}

std::vector<SqliteColumn> columns_of_events() {
  std::vector<SqliteColumn> columns = {{kGameId, game::column_type::kText},
                                       {"number", game::column_type::kInteger}};
  for (const game::DecisionField& field : game::decision_fields())
    if (field.has_column()) columns.push_back({game::column_of(field), field.type});
  return columns;
}

template <typename Row>
std::vector<SqliteColumn> columns_of(const io::TableColumns<Row>& described) {
  std::vector<SqliteColumn> columns = {{kGameId, game::column_type::kText}};
  for (const auto& column : described) columns.push_back({column.name});
  return columns;
}

}  // namespace

std::vector<GameTable> game_tables() {
  return {{"events", columns_of_events()},
          {"chains", columns_of(game::chain_columns({}, 1))},
          {"actions", columns_of(game::action_columns({}, 1))},
          {"shots", columns_of(game::shot_columns({}, 1))}};
}

GameTables::GameTables(std::string id, const game::GameConfiguration& configuration)
    : id_(std::move(id)),
      game_(game::event_game_of(configuration)),
      chain_columns_(game::chain_columns(game_, configuration.sim.frame_rate_hz)),
      action_columns_(game::action_columns(game_, configuration.sim.frame_rate_hz)),
      shot_columns_(game::shot_columns(game_, configuration.sim.frame_rate_hz)) {
  file_.execute("BEGIN");
  for (const GameTable& table : game_tables())
    tables_.push_back(std::make_unique<SqliteTable>(file_, table.name, table.columns));
}

void GameTables::on_decision(const referee::Decision& decision) {
  std::vector<SqliteValue> values = {id_, ++decisions_};
  for (const game::DecisionField& field : game::decision_fields())
    if (field.has_column()) values.push_back(sqlite_value(field.value(decision, game_)));
  tables_[kEvents]->add(values);
}

void GameTables::on_action(const game::BallAction& action) {
  add(kActions, action_columns_, action);
}

void GameTables::on_chain(const game::PossessionChain& chain) {
  add(kChains, chain_columns_, game::ChainRow{++chains_, chain});
}

void GameTables::on_shot(const game::Shot& shot) { add(kShots, shot_columns_, shot); }

template <typename Row>
void GameTables::add(std::size_t table, const io::TableColumns<Row>& columns, const Row& row) {
  std::vector<SqliteValue> values = {id_};
  for (const auto& column : columns) values.push_back(sqlite_value(column.value(row)));
  tables_[table]->add(values);
}

std::string GameTables::bytes() {
  file_.execute("COMMIT");
  return file_.bytes();
}

}  // namespace autoref::experiments
