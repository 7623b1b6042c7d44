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

std::string markdown_table(const JudgeTable& table) {
  const TableRows& rows = table.rows;
  std::vector<std::string> rule(rows.front().size(), "--:");
  std::fill_n(rule.begin(), table.names, "---");
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

// The number of games with this rule book, for each camera and seed.
int games_with(const JudgeReport& report, const std::string& rules) {
  return rules == kAllRules ? report.pooled.front().games : report.tallies.front().games;
}

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string scores_markdown_of(const JudgeReport& report) {
  return markdown_table(scores_table(report, ScoreCells::kWithIntervals));
}

std::string markdown_of(const JudgeReport& report) {
  std::string text = fmt::format("seeds: {}\n\n{}\n{}\n\n{}\n{}\n\n{}\n{}\n\n{}\n{}\n\n{}\n{}\n\n",
                                 text_of(report.seeds), markdown_table(summary_table(report)),
                                 kSummaryCaption, scores_markdown_of(report), kIntervalsCaption,
                                 markdown_table(last_touch_table(report)), kLastTouchCaption,
                                 markdown_table(delays_table(report)), kDelaysCaption,
                                 markdown_table(reliability_table(report)), kReliabilityCaption);
  text += list("events called twice", report.second_calls);
  text += list("calls that require play, made while play was stopped", report.calls_in_stop);
  text += list("right calls of events that happened later", report.calls_before_events);
  text += list("void games", report.void_games);
  text +=
      fmt::format("referee transitions never used: {}\n", joined(report.transitions_never_used));
  text += fmt::format("events never seen: {}\n", joined(report.rules_never_seen));
  for (const std::string& rules : books_in(report)) {
    text += fmt::format("\nrules: {}, {} games with each camera{}\n\n{}", rules,
                        games_with(report, rules), report.seeds.size() > 1 ? " and seed" : "",
                        markdown_table(events_table(report, rules)));
  }
  return text;
}

}  // namespace autoref::runner
