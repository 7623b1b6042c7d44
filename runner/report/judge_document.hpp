// The report of judged games.
#pragma once

#include "runner/batch/result_folder.hpp"
#include "runner/judge/judge_report.hpp"
#include "runner/report/document.hpp"

namespace autoref::runner {

// What was judged, F1 of everything, last touches, what is to be looked up, and all figures of each
// rule book. `direction` leads from the report to the folder of results: "." or "..".
Document judge_document(const ResultFolder& folder, const JudgeReport& report,
                        const std::string& direction);

}  // namespace autoref::runner
