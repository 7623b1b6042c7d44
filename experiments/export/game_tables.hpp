// Tables of what happened in a game, which results folders do not keep: the referee's decisions,
// possession chains, actions with the ball, and shots. They are filled while the game is played.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "experiments/export/sqlite_file.hpp"
#include "game/loop/chain_log.hpp"
#include "game/loop/event_log.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/observer.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {

// Each row begins with the id of its game.
struct GameTable {
  const char* name = "";  // "events"
  std::vector<SqliteColumn> columns;
};

// The tables, in the order in which they are written.
std::vector<GameTable> game_tables();

// The rows of one game, in a database of their own.
class GameTables final : public game::Observer {
 public:
  GameTables(std::string id, const game::GameConfiguration& configuration);

  void on_decision(const referee::Decision& decision) override;
  void on_action(const game::BallAction& action) override;
  void on_chain(const game::PossessionChain& chain) override;
  void on_shot(const game::Shot& shot) override;

  // The database file. Call this once, after the game.
  std::string bytes();

 private:
  template <typename Row>
  void add(std::size_t table, const io::TableColumns<Row>& columns, const Row& row);

  std::string id_;
  game::EventGame game_;
  io::TableColumns<game::ChainRow> chain_columns_;
  io::TableColumns<game::BallAction> action_columns_;
  io::TableColumns<game::Shot> shot_columns_;
  std::int64_t decisions_ = 0;  // numbers of rows so far
  int chains_ = 0;
  SqliteFile file_;
  std::vector<std::unique_ptr<SqliteTable>> tables_;
};

}  // namespace autoref::experiments
