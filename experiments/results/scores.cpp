#include "experiments/results/scores.hpp"

#include <fmt/format.h>

namespace autoref::experiments {

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
