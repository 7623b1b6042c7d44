// The results of an experiment for the page that shows it while it is running.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/results.hpp"
#include "experiments/report/document.hpp"

namespace autoref::experiments {

// Maximum number of rows per table that the page shows, which limits the data sent to each browser.
// A crosstable of more than kMostCrossed teams appears only in the report.
inline constexpr std::size_t kMostTableRows = 200;
inline constexpr std::size_t kMostCrossed = 60;

// Tables and text for the terminal as blocks of a report. Text of several lines becomes Verbatim.
std::vector<Block> blocks_of(const io::TextBlocks& blocks);

// HTML for run_page() (view/page.hpp) made of the report's blocks: the bracket of a cup, the
// standings and crosstable of a tournament, then each kind's tables and how to read them.
std::string run_results_html(const ExperimentResults& results);

}  // namespace autoref::experiments
