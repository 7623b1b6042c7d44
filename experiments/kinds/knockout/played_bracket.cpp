#include "experiments/kinds/knockout/played_bracket.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "experiments/results/scores.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {
namespace {

// The transition into extra time (referee/machine/).
constexpr std::string_view kExtraTime = "extra_time";

DecidedBy reason_of(const game::GameRecord& record) {
  if (record.status == game::Status::kForfeit) return DecidedBy::kForfeit;
  if (record.shootout) return DecidedBy::kShootout;
  const auto& taken = record.transitions;
  const bool had_extra_time = std::find(taken.begin(), taken.end(), kExtraTime) != taken.end();
  return had_extra_time ? DecidedBy::kExtraTime : DecidedBy::kGoals;
}

// Goes through the tie's games until one decides it or has not been played.
void decide(Tie& tie, const RowsById& rows) {
  for (int attempt = 1; attempt <= kMostAttempts; ++attempt) {
    const std::string id = game_id(matchup_name({*tie.a, *tie.b}), tie.number, attempt);
    const auto row = rows.find(id);
    if (row == rows.end()) return;
    tie.games.push_back(id);
    if (is_void(row->second.record)) {
      ++tie.void_games;
      continue;
    }
    const double lead = lead_of_a(row->second.record);
    if (lead == 0) continue;
    tie.decided_by = reason_of(row->second.record);
    tie.a_won = lead > 0;
    return;
  }
  tie.decided_by = DecidedBy::kSeed;
  tie.a_won = true;
}

}  // namespace

std::vector<Tie> bracket_of(const Knockout& knockout, const RowsById& rows) {
  return bracket_of(knockout, [&rows](Tie& tie) { decide(tie, rows); });
}

std::vector<ScheduledGame> games_of(const Knockout& knockout, const std::vector<Tie>& ties) {
  const MatchupScheduler scheduler(knockout);
  std::vector<ScheduledGame> games;
  for (const Tie& tie : ties) {
    if (!tie.is_known()) continue;
    const auto played = static_cast<int>(tie.games.size());
    const int attempts = tie.is_decided() ? played : played + 1;
    for (int attempt = 1; attempt <= attempts; ++attempt) {
      games.push_back(scheduler.game({*tie.a, *tie.b}, tie.number, attempt));
      games.back().unit = static_cast<std::size_t>(tie.number - 1);
    }
  }
  return games;
}

}  // namespace autoref::experiments
