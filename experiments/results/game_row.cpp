#include "experiments/results/game_row.hpp"

#include "game/settings/fields.hpp"

namespace autoref::experiments {

GameRow row_of(const ScheduledGame& game) {
  GameRow row;
  row.game_id = game.id;
  row.pair = game.pair;
  row.leg = game.leg;
  row.values = game.values;
  row.team_a = game.team_a;
  row.team_b = game.team_b;
  row.side_a = game.settings.leg().a_plays;
  row.seed = game.settings.leg().seed;
  row.config_hash = game::configuration_hash(game.settings.whole());
  return row;
}

game::GameRecord void_record(const std::string& reason) {
  game::GameRecord record;
  record.status = game::Status::kVoid;
  record.end_reason = game::EndReason::kVoid;
  record.void_reason = reason;
  return record;
}

}  // namespace autoref::experiments
