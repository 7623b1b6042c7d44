// The judge's tables, as rows of cells; each begins with its heads.
#pragma once

#include <string>
#include <vector>

#include "runner/judge/judge_report.hpp"

namespace autoref::runner {

using TableRows = std::vector<std::vector<std::string>>;

std::vector<std::string> books_in(const JudgeReport& report);

// F1 of every event under each book, the cameras beside each other. Two columns of names.
TableRows scores_rows(const JudgeReport& report);

// How often the last touch at exits was right. Three columns of names.
TableRows last_touch_rows(const JudgeReport& report);

// All figures of a book's events. Two columns of names.
TableRows event_rows(const JudgeReport& report, const std::string& rules);

}  // namespace autoref::runner
