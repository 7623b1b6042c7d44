#include "runner/report/judge_document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runner/judge/judge_tables.hpp"
#include "runner/report/report.hpp"
#include "runner/report/sections.hpp"

namespace autoref::runner {
namespace {

constexpr std::size_t kMostListed = 20;

void add_section(Document& document, const Section& section) {
  document.blocks.insert(document.blocks.end(), section.begin(), section.end());
}

Table table_of(const JudgeTable& table) { return {table.rows, table.names}; }

// Returns an empty section if there are no lines.
Section list_section(const std::string& heading, const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  List list;
  const std::size_t shown = std::min(kMostListed, lines.size());
  list.items.assign(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(shown));
  if (lines.size() > shown) list.items.push_back(fmt::format("and {} more", lines.size() - shown));
  return {Heading{heading}, list};
}

Section judge_commands_section(const ResultFolder& folder, const std::string& direction) {
  const std::string build =
      folder.completed_games.other_builds.empty() ? "" : " --build " + folder.build;
  const std::string effective =
      direction == "." ? kEffectiveFile : fmt::format("{}/{}", direction, kEffectiveFile);
  return {Heading{"How to reproduce"},
          Paragraph{
              "Run these in the folder of this report to judge all games again, to replay five and "
              "compare them, and to replay the game of a fault, given its id in faults.csv:"},
          Verbatim{fmt::format("autoref judge {0} -o again\n"
                               "autoref verify {1}{2} --sample 5\n"
                               "autoref replay {1}{2} ID --view game.html --events events.jsonl\n",
                               effective, direction, build)}};
}

}  // namespace

Document judge_document(const ResultFolder& folder, const JudgeReport& report,
                        const std::string& direction) {
  Document document{title_of(folder.scenario), {}};
  add_section(document, played_section(folder, {}));
  add_section(document,
              {Heading{"Summary"}, table_of(summary_table(report)), Paragraph{kSummaryCaption}});
  add_section(document, {Heading{"F1 by rule book"},
                         Paragraph{"F1 of each event's calls, and how often the event happened."},
                         table_of(scores_table(report, ScoreCells::kWithIntervals)),
                         Paragraph{kIntervalsCaption}});
  add_section(document, {Heading{"Last touch at exits"}, table_of(last_touch_table(report)),
                         Paragraph{kLastTouchCaption}});
  add_section(document, {Heading{"Delays of right calls"}, table_of(delays_table(report)),
                         Paragraph{kDelaysCaption}});
  add_section(document, {Heading{"Confidence"}, table_of(reliability_table(report)),
                         Paragraph{kReliabilityCaption}});
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
    add_section(document, {Heading{"Rules: " + rules}, table_of(events_table(report, rules))});
  add_section(document, settings_section(folder, direction));
  add_section(document, judge_commands_section(folder, direction));
  return document;
}

}  // namespace autoref::runner
