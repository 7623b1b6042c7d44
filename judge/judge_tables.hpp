// The judge's tables as rows of cells, starting with the headings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "judge/judge_report.hpp"

namespace autoref::judge {

using TableRows = std::vector<std::vector<std::string>>;

struct JudgeTable {
  TableRows rows;
  std::size_t names = 1;  // number of leading columns that are names
};

// Texts below the tables.
extern const char* const kSummaryCaption;
extern const char* const kIntervalsCaption;
extern const char* const kLastTouchCaption;
extern const char* const kDelaysCaption;
extern const char* const kReliabilityCaption;

std::vector<std::string> books_in(const JudgeReport& report);

enum class ScoreCells : std::uint8_t {
  kShort,          // "0.987 of 120"
  kWithIntervals,  // "0.987 [0.964, 0.995] of 120"
};

// One row for last touches, one for contested ones, and one for F1 of each event; one column per
// camera. Covers only the games with the last-named seed, under all rule books.
JudgeTable summary_table(const JudgeReport& report);

// F1 of every event by rule book, one column per camera. Each master seed has its own rows, one
// below the other.
JudgeTable scores_table(const JudgeReport& report, ScoreCells cells);

// How often the referee named the right team as the last to touch the ball when it left the field,
// for all exits and for contested ones.
JudgeTable last_touch_table(const JudgeReport& report);

// Delays of all right calls by camera.
JudgeTable delays_table(const JudgeReport& report);

// The share of right calls by the referee's confidence, over all rule books and cameras.
JudgeTable reliability_table(const JudgeReport& report);

// All measures of a rule book's events; for kAllRules, those of the pooled events.
JudgeTable events_table(const JudgeReport& report, const std::string& rules);

}  // namespace autoref::judge
