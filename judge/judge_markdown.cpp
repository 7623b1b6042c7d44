// Renders the judge's report as Markdown and for terminals.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "judge/judge_report.hpp"
#include "judge/judge_tables.hpp"

namespace autoref::judge {
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

// The report's parts, in order.
using Content = std::vector<std::variant<std::string, JudgeTable>>;

Content content_of(const JudgeReport& report) {
  Content content;
  content.emplace_back(fmt::format("seeds: {}\n\n", experiments::text_of(report.seeds)));
  const auto add = [&content](JudgeTable table, std::string_view caption) {
    content.emplace_back(std::move(table));
    content.emplace_back(fmt::format("\n{}\n\n", caption));
  };
  add(summary_table(report), kSummaryCaption);
  add(scores_table(report, ScoreCells::kWithIntervals), kIntervalsCaption);
  add(last_touch_table(report), kLastTouchCaption);
  add(delays_table(report), kDelaysCaption);
  add(reliability_table(report), kReliabilityCaption);
  content.emplace_back(
      list("events called twice", report.second_calls) +
      list("calls that require play, made while play was stopped", report.calls_in_stop) +
      list("right calls of events that happened later", report.calls_before_events) +
      list("void games", report.void_games) +
      fmt::format("referee transitions never used: {}\n", joined(report.transitions_never_used)) +
      fmt::format("events never seen: {}\n", joined(report.rules_never_seen)));
  for (const std::string& rules : books_in(report)) {
    content.emplace_back(fmt::format("\nrules: {}, {} games with each camera{}\n\n", rules,
                                     games_with(report, rules),
                                     report.seeds.size() > 1 ? " and seed" : ""));
    content.emplace_back(events_table(report, rules));
  }
  return content;
}

io::TextTable text_table(JudgeTable table) {
  return {std::move(table.rows), std::vector<io::Align>(table.names, io::Align::kLeft),
          table.names};
}

}  // namespace

std::string scores_markdown_of(const JudgeReport& report) {
  return markdown_table(scores_table(report, ScoreCells::kWithIntervals));
}

io::TextBlocks scores_text_of(const JudgeReport& report) {
  return {text_table(scores_table(report, ScoreCells::kWithIntervals))};
}

std::string markdown_of(const JudgeReport& report) {
  std::string text;
  for (const auto& part : content_of(report)) {
    const auto* table = std::get_if<JudgeTable>(&part);
    text += table != nullptr ? markdown_table(*table) : std::get<std::string>(part);
  }
  return text;
}

io::TextBlocks blocks_of(const JudgeReport& report) {
  io::TextBlocks blocks;
  for (auto& part : content_of(report)) {
    if (auto* table = std::get_if<JudgeTable>(&part))
      blocks.emplace_back(text_table(std::move(*table)));
    else
      blocks.emplace_back(std::move(std::get<std::string>(part)));
  }
  return blocks;
}

}  // namespace autoref::judge
