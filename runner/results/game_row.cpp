#include "runner/results/game_row.hpp"

#include <algorithm>

#include "referee/machine/machine.hpp"
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

std::vector<std::string> transitions_never_used(const RowsById& rows) {
  const auto is_used = [&rows](std::string_view label) {
    return std::any_of(rows.begin(), rows.end(), [label](const auto& entry) {
      const std::vector<std::string_view>& taken = entry.second.record.transitions;
      return std::find(taken.begin(), taken.end(), label) != taken.end();
    });
  };
  std::vector<std::string> never;
  for (const auto& part :
       {referee::transitions_in_figure(), referee::transitions_outside_figure()}) {
    for (const referee::Transition& transition : part) {
      if (!is_used(transition.label)) never.emplace_back(transition.label);
    }
  }
  return never;
}

}  // namespace autoref::runner
