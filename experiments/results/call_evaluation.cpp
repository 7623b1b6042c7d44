#include "experiments/results/call_evaluation.hpp"

#include <fmt/format.h>
#include <utility>

#include "io/csv.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

// Each entry is a CSV line; its first cell is the entry's type.
constexpr std::string_view kVerdict = "v";
constexpr std::string_view kLastTouch = "t";
constexpr std::string_view kContestedTouch = "c";
constexpr std::string_view kInStop = "s";

// Escapes line ends: a row must be a single line, but each entry is a line.
std::string on_one_line(const std::string& lines) {
  std::string text;
  for (const char c : lines) {
    if (c == '\\') text += '\\';
    text += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return text;
}

std::string unescaped(std::string_view text) {
  std::string lines;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size();
    if (is_escape) ++i;
    lines += is_escape && text[i] == 'n' ? '\n' : text[i];
  }
  return lines;
}

std::string flags_of(const CallVerdict& verdict) {
  std::string flags;
  if (verdict.is_early) flags += 'e';
  if (verdict.is_borderline) flags += 'b';
  if (verdict.is_in_air) flags += 'h';
  if (verdict.is_second) flags += '2';
  return flags;
}

std::string line_of(const CallVerdict& verdict) {
  return io::csv_line({std::string(kVerdict), verdict.name,
                       std::to_string(static_cast<int>(verdict.outcome)), flags_of(verdict),
                       fmt::format("{:.4f}", verdict.time_s),
                       verdict.offender ? std::string(name_of(*verdict.offender)) : "",
                       fmt::format("{:.4f}", verdict.delay_s),
                       verdict.error_m ? fmt::format("{:.4f}", *verdict.error_m) : "",
                       verdict.confidence ? fmt::format("{:.4f}", *verdict.confidence) : ""});
}

std::optional<CallOutcome> outcome_in(const std::string& cell) {
  const std::optional<int> number = io::whole_number_in(cell);
  if (!number || *number < 0 || *number > static_cast<int>(CallOutcome::kOvertaken))
    return std::nullopt;
  return static_cast<CallOutcome>(*number);
}

// Reads a side's name, which may be missing: an empty cell leaves `side` empty.
bool read_side(const std::string& cell, std::optional<Side>& side) {
  for (const Side one : kSides) {
    if (cell == name_of(one)) side = one;
  }
  return side.has_value() || cell.empty();
}

bool add_verdict(const io::Cells& cells, CallEvaluation& evaluation) {
  const auto has = [&cells](char flag) { return cells[3].find(flag) != std::string::npos; };
  const std::optional<CallOutcome> outcome = outcome_in(cells[2]);
  const std::optional<double> time_s = io::number_in(cells[4]);
  const std::optional<double> delay_s = io::number_in(cells[6]);
  if (!outcome || !time_s || !delay_s) return false;
  CallVerdict verdict;
  verdict.name = cells[1];
  verdict.outcome = *outcome;
  verdict.is_early = has('e');
  verdict.is_borderline = has('b');
  verdict.is_in_air = has('h');
  verdict.is_second = has('2');
  verdict.time_s = *time_s;
  verdict.delay_s = *delay_s;
  verdict.error_m = io::number_in(cells[7]);
  verdict.confidence = io::number_in(cells[8]);
  if (!read_side(cells[5], verdict.offender)) return false;
  if (!verdict.error_m && !cells[7].empty()) return false;
  if (!verdict.confidence && !cells[8].empty()) return false;
  evaluation.verdicts.push_back(std::move(verdict));
  return true;
}

using TeamTouches = std::array<LastTouchTally, 2>;

std::string touch_lines(std::string_view type, const TeamTouches& by_team) {
  std::string lines;
  for (std::size_t team = 0; team < by_team.size(); ++team) {
    const LastTouchTally& tally = by_team[team];
    lines += io::csv_line({std::string(type), team == 0 ? "a" : "b", std::to_string(tally.right),
                           std::to_string(tally.wrong), std::to_string(tally.unknown)}) +
             "\n";
  }
  return lines;
}

bool add_touches(const io::Cells& cells, TeamTouches& by_team) {
  const std::optional<int> right = io::whole_number_in(cells[2]);
  const std::optional<int> wrong = io::whole_number_in(cells[3]);
  const std::optional<int> unknown = io::whole_number_in(cells[4]);
  if (!right || !wrong || !unknown || (cells[1] != "a" && cells[1] != "b")) return false;
  by_team[cells[1] == "a" ? 0 : 1] = {*right, *wrong, *unknown};
  return true;
}

bool add_entry(const io::Cells& cells, CallEvaluation& evaluation) {
  if (cells[0] == kVerdict && cells.size() == 9) return add_verdict(cells, evaluation);
  if (cells[0] == kLastTouch && cells.size() == 5) return add_touches(cells, evaluation.last_touch);
  if (cells[0] == kContestedTouch && cells.size() == 5)
    return add_touches(cells, evaluation.contested_touch);
  if (cells[0] != kInStop || cells.size() != 2) return false;
  evaluation.calls_in_stop.push_back(cells[1]);
  return true;
}

}  // namespace

std::string text_of(const CallEvaluation& evaluation) {
  std::string lines;
  for (const CallVerdict& verdict : evaluation.verdicts) lines += line_of(verdict) + "\n";
  lines += touch_lines(kLastTouch, evaluation.last_touch);
  lines += touch_lines(kContestedTouch, evaluation.contested_touch);
  for (const std::string& call : evaluation.calls_in_stop)
    lines += io::csv_line({std::string(kInStop), call}) + "\n";
  return on_one_line(lines);
}

std::optional<CallEvaluation> evaluation_in(std::string_view text) {
  const std::string lines = unescaped(text);
  CallEvaluation evaluation;
  for (const std::string_view line : io::complete_lines(lines)) {
    const std::optional<io::Cells> cells = io::csv_cells(line);
    if (!cells || !add_entry(*cells, evaluation)) return std::nullopt;
  }
  return evaluation;
}

}  // namespace autoref::experiments
