#include "runner/analysis/played_bracket.hpp"

#include <fmt/format.h>

#include <string>

#include "runner/experiments/matchup_schedule.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/results/scores.hpp"

namespace autoref::runner {
namespace {

DecidedBy reason_of(const Cells& row, const ScoreColumns& at, std::size_t transitions) {
  if (row[at.status] == name_of(Status::kForfeit)) return DecidedBy::kForfeit;
  if (!row[at.shootout_a].empty()) return DecidedBy::kShootout;
  const bool had_extra_time =
      fmt::format("+{}+", row[transitions]).find("+extra_time+") != std::string::npos;
  return had_extra_time ? DecidedBy::kExtraTime : DecidedBy::kGoals;
}

// Goes through the tie's games until one decides it or has no row.
void decide(Tie& tie, const RowFormat& format, const RowsById& rows) {
  const ScoreColumns at(format);
  for (int attempt = 1; attempt <= kMostAttempts; ++attempt) {
    const std::string id = game_id(matchup_name({*tie.a, *tie.b}), tie.number, attempt);
    const auto row = rows.find(id);
    if (row == rows.end()) return;
    tie.games.push_back(id);
    if (is_void(row->second, at)) {
      ++tie.void_games;
      continue;
    }
    const double lead = lead_of_a(row->second, at);
    if (lead == 0) continue;
    tie.decided_by = reason_of(row->second, at, format.column("transitions"));
    tie.a_won = lead > 0;
    return;
  }
  tie.decided_by = DecidedBy::kSeed;
  tie.a_won = true;
}

}  // namespace

std::vector<Tie> bracket_of(const Knockout& knockout, const RowFormat& format,
                            const RowsById& rows) {
  return bracket_of(knockout, [&](Tie& tie) { decide(tie, format, rows); });
}

}  // namespace autoref::runner
