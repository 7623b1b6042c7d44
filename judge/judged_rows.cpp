#include "judge/judged_rows.hpp"

#include <fmt/format.h>

#include <utility>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/results/call_evaluation.hpp"
#include "io/words.hpp"
#include "judge/judge_tables.hpp"

namespace autoref::judge {
namespace {

constexpr std::size_t kLongestText = 90'000;  // a worker's answer is limited to 100 kB

const experiments::JudgeSchedule& schedule_of(const experiments::ResultFolder& folder) {
  return folder.scenario.get<experiments::JudgeSchedule>();
}

// Describes the fault with this number in the game's row; empty if the row has no such fault.
std::string fault_text(const experiments::ResultFolder& folder, const std::string& game_id,
                       int number) {
  const auto row = folder.completed_games.done.find(game_id);
  if (row == folder.completed_games.done.end()) return {};
  const auto faults = faults_in(row->second.evaluation);
  if (number < 1 || number > static_cast<int>(faults.size())) return {};
  const experiments::CallVerdict& fault = *faults[static_cast<std::size_t>(number - 1)];
  const bool is_missed = fault.outcome == experiments::CallOutcome::kMissed;
  return fmt::format("{} {}{} at {:.3f} s", is_missed ? "missed" : "wrong", fault.name,
                     fault.offender ? fmt::format(" of {}", name_of(*fault.offender)) : "",
                     fault.time_s);
}

}  // namespace

void keep(EvaluatedGame judged, experiments::GameRow& row) {
  row.record = std::move(judged.record);
  row.evaluation = std::move(judged.evaluation);
  const std::size_t size = experiments::text_of(row.evaluation).size();
  if (size <= kLongestText) return;
  row.evaluation = {};
  row.record = experiments::void_record(
      fmt::format("its evaluation has {} bytes, but a row holds at most {}: use shorter halves",
                  size, kLongestText));
}

void play_judged(const game::GameConfiguration& game, game::GamePrograms& programs,
                 experiments::GameRow& row) {
  keep(evaluate_calls(game, programs.maker()), row);
}

experiments::Outcomes judged_outcomes(const experiments::JudgeSchedule& schedule,
                                      const std::filesystem::path& folder) {
  const auto view = [&schedule](const experiments::RowsById& rows) {
    const io::ProgressTable scores{
        scores_table(report_of(schedule, rows), ScoreCells::kShort).rows, {}, "events"};
    return io::ProgressView{"so far:", {scores}, {}};
  };
  const auto play = [folder](const game::GameConfiguration& game, experiments::GameRow& row) {
    experiments::play_live(game, folder,
                           [&game, &row](game::GamePrograms& programs) -> game::GameRecord& {
                             play_judged(game, programs, row);
                             return row.record;
                           });
  };
  return {play, view};
}

JudgeReport report_of(const experiments::ResultFolder& folder) {
  return report_of(schedule_of(folder), folder.completed_games.done);
}

std::optional<FoundGame> find_game(const experiments::ResultFolder& folder, const std::string& id) {
  const std::size_t mark = id.rfind(kFaultMark);
  const std::optional<int> number = mark == std::string::npos
                                        ? std::nullopt
                                        : io::whole_number_in(id.substr(mark + kFaultMark.size()));
  for (const experiments::ScheduledJudgeGame& game : experiments::games_of(schedule_of(folder))) {
    if (id == game.id || id == game.game_id) return FoundGame{game.game_id, {}};
    if (!number || id.substr(0, mark) != game.game_id) continue;
    const std::string fault = fault_text(folder, game.game_id, *number);
    if (fault.empty()) return std::nullopt;
    return FoundGame{game.game_id, fault};
  }
  return std::nullopt;
}

}  // namespace autoref::judge
