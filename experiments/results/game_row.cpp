#include "experiments/results/game_row.hpp"

#include <fmt/format.h>

#include "game/settings/fields.hpp"
#include "soccer/rules/rule_changes.hpp"

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
  const game::GameSettings settings = game.settings.combined();
  row.rule_changes = text_of(rule_changes(settings.match.rules, settings.field));
  row.config_hash = game::configuration_hash(settings);
  return row;
}

std::vector<std::string> rule_notes(const RowsById& rows) {
  std::map<std::string, std::size_t> games;
  for (const auto& [id, row] : rows)
    if (!row.rule_changes.empty()) ++games[row.rule_changes];
  std::vector<std::string> notes;
  for (const auto& [changes, count] : games) {
    const std::string text = not_official_text(changes);
    notes.push_back(
        count == rows.size() ? text : fmt::format("{} of {} games: {}", count, rows.size(), text));
  }
  return notes;
}

game::GameRecord void_record(const std::string& reason) {
  game::GameRecord record;
  record.status = game::Status::kVoid;
  record.end_reason = game::EndReason::kVoid;
  record.void_reason = reason;
  return record;
}

bool is_void(const game::GameRecord& record) { return record.status == game::Status::kVoid; }

double lead_of_a(const game::GameRecord& record) {
  if (record.end_reason == game::EndReason::kForfeitA) return -1;
  if (record.end_reason == game::EndReason::kForfeitB) return 1;
  const int goals = record.goals_a - record.goals_b;
  if (goals != 0 || !record.shootout) return goals;
  return (*record.shootout)[0] - (*record.shootout)[1];
}

std::string score_text(const game::GameRecord& record) {
  if (is_void(record)) return "void";
  std::string goals = fmt::format("{}:{}", record.goals_a, record.goals_b);
  if (!record.shootout) return goals;
  return fmt::format("{} ({}:{})", goals, (*record.shootout)[0], (*record.shootout)[1]);
}

}  // namespace autoref::experiments
