#include "judge/judge_document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/report/report.hpp"
#include "experiments/report/sections.hpp"
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
          experiments::Verbatim{
              fmt::format("autoref judge {0} -o again\n"
                          "autoref verify {1}{2} --sample 5\n"
                          "autoref replay {1}{2} ID --view game.html --events events.jsonl\n",
                          effective, direction, build)}};
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

}  // namespace autoref::judge
