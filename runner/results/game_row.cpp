#include "runner/results/game_row.hpp"

#include "runner/settings/fields.hpp"

namespace autoref::runner {

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
  row.config_hash = configuration_hash(game.settings.whole());
  return row;
}

GameRecord void_record(const std::string& reason) {
  GameRecord record;
  record.status = Status::kVoid;
  record.end_reason = EndReason::kVoid;
  record.void_reason = reason;
  return record;
}

}  // namespace autoref::runner
