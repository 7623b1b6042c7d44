// Reports of experiments: one for people to read, one for a browser, and plots.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runner/batch/result_folder.hpp"
#include "runner/report/document.hpp"
#include "runner/report/gnuplot.hpp"

namespace autoref::runner {

inline constexpr const char* kPlotsFolder = "plots";
inline constexpr const char* kMarkdownReport = "report.md";
inline constexpr const char* kHtmlReport = "report.html";

// What the scenario says of itself, or else its kind.
std::string title_of(const Scenario& scenario);

struct WrittenReport {
  int drawn = 0;                      // plots
  std::vector<std::string> troubles;  // why others are not, a line each
};

// Writes report.md, report.html and plots/ into `into`, which is the folder of results or one
// directly below it. A plot that cannot be drawn has its .csv and .gp all the same; a drawing of it
// that is there from before is removed, since it would show something else; so are the plots that
// an earlier report wrote and this one does not have. The same rows give the same files, byte by
// byte, wherever the folder is.
WrittenReport write_report(const ResultFolder& folder, const ExperimentResults& results,
                           const std::filesystem::path& into);

}  // namespace autoref::runner
