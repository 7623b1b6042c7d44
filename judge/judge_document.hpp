// The report on judged games.
#pragma once

#include "experiments/report/document.hpp"
#include "experiments/run/result_folder.hpp"
#include "judge/judge_report.hpp"

namespace autoref::judge {

// Contains the scope of the evaluation, F1 of all events, last touches, calls to inspect, and all
// measures by rule book. `direction` is the path from the report to the results folder: "." or
// "..".
experiments::Document judge_document(const experiments::ResultFolder& folder,
                                     const JudgeReport& report, const std::string& direction);

}  // namespace autoref::judge
