// Renders the judge's report as Markdown.
#include <fmt/format.h>

#include <algorithm>

#include "runner/judge/judge_report.hpp"
#include "runner/judge/judge_tables.hpp"

namespace autoref::runner {
namespace {

std::string markdown_row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string markdown_table(const TableRows& rows, std::size_t names) {
  std::vector<std::string> rule(rows.front().size(), "--:");
  std::fill_n(rule.begin(), names, "---");
  std::string text = markdown_row(rows.front()) + fmt::format("|{}|\n", fmt::join(rule, "|"));
  for (std::size_t i = 1; i < rows.size(); ++i) text += markdown_row(rows[i]);
  return text;
}

std::string list(const std::string& what, const std::vector<std::string>& lines) {
  constexpr std::size_t kMost = 20;
  std::string text =
      fmt::format("{}: {}\n", what, lines.empty() ? "none" : std::to_string(lines.size()));
  for (std::size_t i = 0; i < std::min(kMost, lines.size()); ++i) text += "- " + lines[i] + "\n";
  if (lines.size() > kMost) text += fmt::format("- and {} more\n", lines.size() - kMost);
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string scores_markdown_of(const JudgeReport& report) {
  return markdown_table(scores_rows(report), 2);
}

std::string markdown_of(const JudgeReport& report) {
  std::string text =
      scores_markdown_of(report) + "\n" + markdown_table(last_touch_rows(report), 3) + "\n";
  text += list("events called twice", report.second_calls);
  text += list("calls that require play, made while play was stopped", report.calls_in_stop);
  text += list("void games", report.void_games);
  text +=
      fmt::format("referee transitions never used: {}\n", joined(report.transitions_never_used));
  text += fmt::format("events never seen: {}\n", joined(report.rules_never_seen));
  for (const std::string& rules : books_in(report)) {
    text += fmt::format("\nrules: {}, {} games with each camera\n\n{}", rules,
                        report.tallies.front().games, markdown_table(event_rows(report, rules), 2));
  }
  return text;
}

}  // namespace autoref::runner
