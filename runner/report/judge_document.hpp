// The report on judged games.
#pragma once

#include "runner/batch/result_folder.hpp"
#include "runner/judge/judge_report.hpp"
#include "runner/report/document.hpp"

namespace autoref::runner {

// What was judged, F1 of all events, last touches, calls to inspect, and all measures by rule book.
// `direction` is the path from the report to the results folder: "." or "..".
Document judge_document(const ResultFolder& folder, const JudgeReport& report,
                        const std::string& direction);

}  // namespace autoref::runner
