// Reports of experiments as Markdown, HTML and plots.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/report/document.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/run/result_folder.hpp"

namespace autoref::experiments {

inline constexpr const char* kPlotsFolder = "plots";
inline constexpr const char* kMarkdownReport = "report.md";
inline constexpr const char* kHtmlReport = "report.html";

// The scenario's `about` text, or its kind.
std::string title_of(const Scenario& scenario);

struct WrittenReport {
  int drawn = 0;                      // number of plots drawn
  std::vector<std::string> troubles;  // one line per plot that was not drawn, with the reason
};

// Writes report.md, report.html and plots/ into `into`, which is the results folder or a direct
// subfolder. A plot that cannot be drawn still gets its .csv and .gp. Removes outdated drawings:
// those of plots that can no longer be drawn, and those of plots that are in an earlier report but
// not in this one. Equal rows give identical files, regardless of the folder's location.
WrittenReport write_report(const ResultFolder& folder, const ExperimentResults& results,
                           const std::filesystem::path& into);

}  // namespace autoref::experiments
