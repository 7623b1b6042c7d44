// The results of an experiment for the page that shows it while it runs.
#pragma once

#include <string>

#include "experiments/kinds/results.hpp"

namespace autoref::experiments {

// Rows of a table that the page shows at most; a crosstable of more than kMostCrossed teams is left
// to the report. This bounds what each watcher is sent.
inline constexpr std::size_t kMostTableRows = 200;
inline constexpr std::size_t kMostCrossed = 60;

// HTML for run_page() (view/page.hpp), of the report's blocks: the bracket of a cup, standings and
// crosstable of a tournament, then the tables of all kinds and how to read them.
std::string run_results_html(const ExperimentResults& results);

}  // namespace autoref::experiments
