#include "runner/judge/judged_rows.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "runner/io/checksum.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"

namespace autoref::runner {
namespace {

constexpr std::size_t kLongestText = 90'000;  // that comes back from a worker

// A row is a line: line ends within a cell are written out.
std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    if (c == '\\') line += '\\';
    line += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return line;
}

std::string lines_in(const std::string& line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_escape = line[i] == '\\' && i + 1 < line.size();
    if (is_escape) ++i;
    text += is_escape && line[i] == 'n' ? '\n' : line[i];
  }
  return text;
}

CallEvaluation void_evaluation(const std::string& reason) {
  CallEvaluation evaluation;
  evaluation.void_reason = reason;
  return evaluation;
}

const JudgeSchedule& schedule_of(const ResultFolder& folder) {
  return std::get<JudgeSchedule>(folder.scenario.content);
}

JudgeReport report_of_rows(const JudgeSchedule& schedule, const RowFormat& format,
                           const RowsById& rows) {
  std::vector<JudgeGame> games;
  std::vector<CallEvaluation> evaluations;
  for (JudgeGame& game : games_of(schedule)) {
    const auto row = rows.find(game.game_id);
    if (row == rows.end()) continue;
    evaluations.push_back(evaluation_in_row(format, row->second));
    games.push_back(std::move(game));
  }
  return report_of(schedule, games, evaluations);
}

// The fault of that number in the game's row; empty where there is none.
std::string fault_text(const ResultFolder& folder, const std::string& game_id, int number) {
  const auto row = folder.completed_games.done.find(game_id);
  if (row == folder.completed_games.done.end()) return {};
  const CallEvaluation evaluation = evaluation_in_row(folder.format, row->second);
  const auto faults = faults_in(evaluation);
  if (number < 1 || number > static_cast<int>(faults.size())) return {};
  const ground_truth::Verdict& fault = *faults[static_cast<std::size_t>(number - 1)];
  const bool is_missed = fault.outcome == ground_truth::Outcome::kMissed;
  return fmt::format("{} {}{} at {:.3f} s", is_missed ? "missed" : "wrong", fault.name,
                     fault.offender ? fmt::format(" of {}", name_of(*fault.offender)) : "",
                     fault.time_s);
}

}  // namespace

Cells evaluation_cells(const CallEvaluation& evaluation) {
  const std::string text = text_of(evaluation);
  if (text.size() > kLongestText) {
    return evaluation_cells(void_evaluation(
        fmt::format("its evaluation has {} bytes, of which {} fit a row: let halves be shorter",
                    text.size(), kLongestText)));
  }
  const bool is_void = !evaluation.void_reason.empty();
  return {std::string(name_of(is_void ? Status::kVoid : Status::kOk)), evaluation.void_reason,
          hash_text(evaluation.state_hash), one_line(text)};
}

CallEvaluation evaluation_in_row(const RowFormat& format, const Cells& row) {
  return evaluation_in(lines_in(row[format.column("evaluation")]));
}

Cells judged(const GameConfiguration& game) { return evaluation_cells(evaluate_calls(game)); }

Outcomes judged_outcomes(const JudgeSchedule& schedule, const RowFormat& format) {
  const auto view = [&schedule, &format](const std::vector<Cells>& rows) {
    RowsById by_id;
    for (const Cells& row : rows) by_id[row.front()] = row;
    const ProgressTable scores{scores_rows(report_of_rows(schedule, format, by_id)), {}, "events"};
    return ProgressView{"so far:", {scores}, {}};
  };
  const auto voided = [](const std::string& reason) {
    return evaluation_cells(void_evaluation(reason));
  };
  return {judged, voided, view};
}

JudgeReport report_of(const ResultFolder& folder) {
  try {
    return report_of_rows(schedule_of(folder), folder.format, folder.completed_games.done);
  } catch (const std::invalid_argument& error) {
    throw InputError({folder.path.string()}, "", error.what());
  }
}

std::optional<LookedUp> look_up(const ResultFolder& folder, const std::string& id) {
  const std::size_t mark = id.rfind(kFaultMark);
  const std::optional<int> number = mark == std::string::npos
                                        ? std::nullopt
                                        : whole_number_in(id.substr(mark + kFaultMark.size()));
  for (const JudgeGame& game : games_of(schedule_of(folder))) {
    if (id == game.id || id == game.game_id) return LookedUp{game.game_id, {}};
    if (!number || id.substr(0, mark) != game.game_id) continue;
    const std::string fault = fault_text(folder, game.game_id, *number);
    if (fault.empty()) return std::nullopt;
    return LookedUp{game.game_id, fault};
  }
  return std::nullopt;
}

}  // namespace autoref::runner
