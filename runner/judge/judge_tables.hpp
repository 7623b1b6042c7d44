// The judge's tables as rows of cells, starting with the headings.
#pragma once

#include <string>
#include <vector>

#include "runner/judge/judge_report.hpp"

namespace autoref::runner {

using TableRows = std::vector<std::vector<std::string>>;

std::vector<std::string> books_in(const JudgeReport& report);

// F1 of every event by rule book, one column per camera. The first two columns are names.
TableRows scores_rows(const JudgeReport& report);

// How often the last touch was right when the ball left the field. The first three columns are
// names.
TableRows last_touch_rows(const JudgeReport& report);

// All measures of a rule book's events. The first two columns are names.
TableRows event_rows(const JudgeReport& report, const std::string& rules);

}  // namespace autoref::runner
