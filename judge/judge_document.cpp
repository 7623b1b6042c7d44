// The judge's report as a document, as Markdown and for terminals (the latter two declared in
// judge_report.hpp).
#include "judge/judge_document.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <utility>
#include <variant>

#include "experiments/report/report.hpp"
#include "experiments/report/sections.hpp"
#include "judge/judge_report.hpp"
#include "judge/judge_tables.hpp"

namespace autoref::judge {
namespace {

constexpr std::size_t kMostListed = 20;

void add_section(experiments::Document& document, const experiments::Section& section) {
  document.blocks.insert(document.blocks.end(), section.begin(), section.end());
}

experiments::Table table_of(const JudgeTable& table) { return {table.rows, table.names}; }

// Returns an empty section if there are no lines.
experiments::Section list_section(const std::string& heading,
                                  const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  experiments::List list;
  const std::size_t shown = std::min(kMostListed, lines.size());
  list.items.assign(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(shown));
  if (lines.size() > shown) list.items.push_back(fmt::format("and {} more", lines.size() - shown));
  return {experiments::Heading{heading}, list};
}

experiments::Section judge_commands_section(const experiments::ResultFolder& folder,
                                            const std::string& direction) {
  const std::string build =
      folder.completed_games.other_builds.empty() ? "" : " --build " + folder.build;
  const std::string effective = direction == "."
                                    ? experiments::kEffectiveFile
                                    : fmt::format("{}/{}", direction, experiments::kEffectiveFile);
  return {experiments::Heading{"How to reproduce"},
          experiments::Paragraph{
              "Run these in the folder of this report to judge all games again, to replay five and "
              "compare them, and to replay the game of a fault, given its id in faults.csv:"},
          experiments::Verbatim{fmt::format(
              "autoref judge {0} -o again\n"
              "autoref results verify {1}{2} --sample 5\n"
              "autoref results replay {1}{2} ID --view game.html --events events.jsonl\n",
              effective, direction, build)}};
}

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

experiments::Document judge_document(const experiments::ResultFolder& folder,
                                     const JudgeReport& report, const std::string& direction) {
  experiments::Document document{experiments::title_of(folder.scenario), {}};
  add_section(document, experiments::played_section(folder, {}));
  add_section(document, {experiments::Heading{"Summary"}, table_of(summary_table(report)),
                         experiments::Paragraph{kSummaryCaption}});
  add_section(
      document,
      {experiments::Heading{"F1 by rule book"},
       experiments::Paragraph{"F1 of each event's calls, and how often the event happened."},
       table_of(scores_table(report, ScoreCells::kWithIntervals)),
       experiments::Paragraph{kIntervalsCaption}});
  add_section(document,
              {experiments::Heading{"Last touch at exits"}, table_of(last_touch_table(report)),
               experiments::Paragraph{kLastTouchCaption}});
  add_section(document, {experiments::Heading{"Delays of right calls"},
                         table_of(delays_table(report)), experiments::Paragraph{kDelaysCaption}});
  add_section(document, {experiments::Heading{"Confidence"}, table_of(reliability_table(report)),
                         experiments::Paragraph{kReliabilityCaption}});
  add_section(document, list_section("Events called twice", report.second_calls));
  add_section(document, list_section("Calls that require play, made while play was stopped",
                                     report.calls_in_stop));
  add_section(document, list_section("Right calls of events that happened later",
                                     report.calls_before_events));
  add_section(document, list_section("Void games", report.void_games));
  add_section(document,
              list_section("Referee transitions never used", report.transitions_never_used));
  add_section(document, list_section("Events never seen", report.rules_never_seen));
  for (const std::string& rules : books_in(report))
    add_section(document,
                {experiments::Heading{"Rules: " + rules}, table_of(events_table(report, rules))});
  add_section(document, experiments::settings_section(folder, direction));
  add_section(document, judge_commands_section(folder, direction));
  return document;
}

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
