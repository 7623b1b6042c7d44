// Reports on a judged referee: tables, CSV and JSON.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/results/game_row.hpp"
#include "io/table.hpp"
#include "judge/judge_tally.hpp"

namespace autoref::judge {

struct JudgeReport {
  std::vector<experiments::NamedSeed> seeds;  // the master seeds of the schedule
  // Tallies by rule book, camera and seed, in the order of the schedule.
  std::vector<CameraTally> tallies;
  // The tallies pooled over all rule books; empty if there is only one rule book.
  std::vector<CameraTally> pooled;
  // Events seen under several rule books that are rare in some tally.
  std::set<std::string> rare_events;
  // Calls to inspect: one line each, with the game's id.
  std::vector<std::string> second_calls;  // calls of events that had already been called
  // Calls made while play was stopped, although they are possible only during play.
  std::vector<std::string> calls_in_stop;
  std::vector<std::string> calls_before_events;  // right calls of events that happened later
  std::vector<std::string> void_games;
  std::vector<std::string> transitions_never_used;
  std::vector<std::string>
      rules_never_seen;    // events that neither occurred nor were called in any game
  std::string faults_csv;  // one row per missed event or wrong call
};

// Separates a game's id from the number of a fault in it, counted from 1: "...-p0002-1-f3".
inline constexpr std::string_view kFaultMark = "-f";

// The missed events and wrong calls in the order of their numbers.
std::vector<const experiments::CallVerdict*> faults_in(
    const experiments::CallEvaluation& evaluation);

// The report on the scheduled games with rows, in the order of the schedule. Equal rows give the
// same report, regardless of the order in which the games were played.
JudgeReport report_of(const experiments::JudgeSchedule& schedule,
                      const experiments::RowsById& rows);

// The report as Markdown: the seeds, a summary, F1 of all events by rule book, last touches,
// delays, the checks, and a table of all measures for each rule book.
std::string markdown_of(const JudgeReport& report);

// The report for a terminal, where the rows of Markdown tables would be far too wide.
io::TextBlocks blocks_of(const JudgeReport& report);

// The part of the report with the table of F1 by rule book, as Markdown.
std::string scores_markdown_of(const JudgeReport& report);
io::TextBlocks scores_text_of(const JudgeReport& report);

// judge.csv: seeds, rules, camera, event, whether it is rare, and measures with their intervals;
// cells without a value are empty. Last touches are included as an event. Rows with the rule book
// kAllRules pool events that are rare under some rule book.
std::string csv_of(const JudgeReport& report);

// The report as one JSON object.
std::string json_of(const JudgeReport& report);

}  // namespace autoref::judge
