#include "experiments/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/report/plots.hpp"
#include "experiments/report/sections.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

struct DrawnPlot {
  Plot plot;
  Drawing drawing;
};

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw io::InputOutputError(fmt::format("{}: {}", file.string(), error.message()));
}

// Removes plots that an earlier report drew and this one does not. Files with other names belong to
// the user.
void remove_other_plots(const fs::path& folder, const std::vector<DrawnPlot>& plots) {
  for (const std::string name : kPlotNames) {
    const bool is_here = std::any_of(plots.begin(), plots.end(), [&name](const DrawnPlot& drawn) {
      return drawn.plot.name == name;
    });
    if (is_here) continue;
    for (const char* ending : {".csv", ".gp", ".svg"}) remove_file(folder / (name + ending));
  }
}

// Stops trying as soon as gnuplot turns out to be missing.
std::vector<DrawnPlot> drawn(const std::vector<Plot>& plots) {
  std::vector<DrawnPlot> all;
  for (const Plot& plot : plots) {
    const bool is_missing = !all.empty() && all.back().drawing.is_missing;
    all.push_back({plot, is_missing ? all.back().drawing : draw(plot)});
  }
  return all;
}

void write_plots(const fs::path& folder, const std::vector<DrawnPlot>& plots) {
  io::create_folder(folder);
  for (const auto& [plot, drawing] : plots) {
    io::replace_file(folder / (plot.name + ".csv"), plot.csv);
    io::replace_file(folder / (plot.name + ".gp"), plot.script);
    const fs::path svg = folder / (plot.name + ".svg");
    drawing.svg.empty() ? remove_file(svg) : io::replace_file(svg, drawing.svg);
  }
  remove_other_plots(folder, plots);
}

std::string missing_text(const std::string& direction) {
  return fmt::format(
      "The plots are not drawn, because gnuplot is not installed. Run apt-get install "
      "gnuplot-nox, then "
      "autoref report {}. Their data and scripts are in {}.",
      direction, kPlotsFolder);
}

std::vector<std::string> troubles_of(const std::vector<DrawnPlot>& plots,
                                     const std::string& direction) {
  if (!plots.empty() && plots.front().drawing.is_missing) return {missing_text(direction)};
  std::vector<std::string> troubles;
  for (const auto& [plot, drawing] : plots) {
    if (drawing.trouble.empty()) continue;
    troubles.push_back(
        fmt::format("{}/{}.svg is not drawn: {}", kPlotsFolder, plot.name, drawing.trouble));
  }
  return troubles;
}

Section plots_section(const std::vector<DrawnPlot>& plots, const std::string& direction) {
  if (plots.empty()) return {};
  Section section = {Heading{"Plots"}};
  for (const std::string& trouble : troubles_of(plots, direction)) {
    section.emplace_back(Paragraph{trouble});
  }
  for (const auto& [plot, drawing] : plots) {
    if (!drawing.svg.empty()) {
      section.emplace_back(Figure{kPlotsFolder, plot.name, plot.about, drawing.svg});
    }
  }
  return section;
}

// The path from a report to its results folder.
std::string direction_from(const fs::path& into, const ResultFolder& folder) {
  return into == folder.path ? "." : "..";
}

Document document_of(const ResultFolder& folder, const ExperimentResults& results,
                     const std::vector<DrawnPlot>& plots, const fs::path& into) {
  const std::string direction = direction_from(into, folder);
  Document document{title_of(folder.scenario), {}};
  for (const Section& section :
       {played_section(folder, results), results_section(results), bracket_section(results),
        drawings_section(folder, results, into), plots_section(plots, direction),
        shares_section(folder, results), crosstable_section(results), void_section(folder),
        settings_section(folder, direction), commands_section(folder, direction)}) {
    document.blocks.insert(document.blocks.end(), section.begin(), section.end());
  }
  return document;
}

}  // namespace

std::string title_of(const Scenario& scenario) {
  return scenario.about.empty() ? fmt::format("A {}", kind_of(scenario)) : scenario.about;
}

WrittenReport write_report(const ResultFolder& folder, const ExperimentResults& results,
                           const fs::path& into) {
  const std::string direction = direction_from(into, folder);
  const std::vector<DrawnPlot> plots = drawn(plots_of(folder.scenario, results));
  write_plots(into / kPlotsFolder, plots);
  const Document document = document_of(folder, results, plots, into);
  io::replace_file(into / kMarkdownReport, markdown_of(document));
  io::replace_file(into / kHtmlReport, html_of(document));
  WrittenReport written{0, troubles_of(plots, direction)};
  for (const auto& [plot, drawing] : plots) written.drawn += drawing.svg.empty() ? 0 : 1;
  return written;
}

}  // namespace autoref::experiments
