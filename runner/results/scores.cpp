#include "runner/results/scores.hpp"

#include "runner/io/words.hpp"

namespace autoref::runner {

ScoreColumns::ScoreColumns(const RowFormat& format)
    : goals_a(format.column("goals_a")),
      goals_b(format.column("goals_b")),
      status(format.column("status")),
      end_reason(format.column("end_reason")),
      shootout_a(format.column("shootout_a")),
      shootout_b(format.column("shootout_b")),
      pair(format.column("pair")) {}

bool is_void(const Cells& row, const ScoreColumns& at) {
  return row[at.status] == name_of(Status::kVoid);
}

double lead_of_a(const Cells& row, const ScoreColumns& at) {
  if (row[at.end_reason] == name_of(EndReason::kForfeitA)) return -1;
  if (row[at.end_reason] == name_of(EndReason::kForfeitB)) return 1;
  const double goals = number_in(row[at.goals_a]).value() - number_in(row[at.goals_b]).value();
  if (goals != 0 || row[at.shootout_a].empty()) return goals;
  return number_in(row[at.shootout_a]).value() - number_in(row[at.shootout_b]).value();
}

}  // namespace autoref::runner
