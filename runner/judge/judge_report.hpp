// What is told of a judged referee: tables for people, rows and objects for programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runner/experiments/judge_schedule.hpp"
#include "runner/judge/judge_tally.hpp"
#include "runner/results/game_row.hpp"

namespace autoref::runner {

struct JudgeReport {
  std::vector<CameraTally> tallies;  // book by book, camera by camera, in the plan's order
  // A line each, for looking a game up again.
  std::vector<std::string> second_calls;   // another call had answered the event already
  std::vector<std::string> calls_in_stop;  // calls that need play, while there was none
  std::vector<std::string> void_games;
  std::vector<std::string> transitions_never_used;
  std::vector<std::string> rules_never_seen;  // calls that no game gave, of events that no game had
  std::string faults_csv;                     // a row per missed event and wrong call
};

// Between a game's id and the number of a fault in it, from 1: "...-p0002-1-f3".
inline constexpr std::string_view kFaultMark = "-f";

// The missed events and wrong calls, in the order of their numbers.
std::vector<const ground_truth::Verdict*> faults_in(const CallEvaluation& evaluation);

// The scheduled games that have rows, in the schedule's order: the same rows give the same report,
// in whatever order they were played.
JudgeReport report_of(const JudgeSchedule& schedule, const RowsById& rows);

// Markdown: F1 of everything at a glance, last touches, the checks, and a table of all figures for
// each rule book.
std::string markdown_of(const JudgeReport& report);

// F1 of everything alone.
std::string scores_markdown_of(const JudgeReport& report);

// judge.csv: rules, camera, event, and figures; cells without a value are empty.
std::string csv_of(const JudgeReport& report);

// One JSON object.
std::string json_of(const JudgeReport& report);

}  // namespace autoref::runner
