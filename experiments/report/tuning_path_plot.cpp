#include <fmt/format.h>

#include <algorithm>

#include "experiments/report/plots.hpp"
#include "io/csv.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr int kPathPanel_px = 150;
constexpr int kPathBetween_px = 34;
constexpr int kPathTop_px = 58;
constexpr int kPathBottom_px = 70;
constexpr double kPathMargin = 0.05;      // fraction of the span, above and below
constexpr std::size_t kMostPanels = 16;   // more would be unreadable
constexpr std::size_t kLongestName = 60;  // maximum number of characters

std::string csv_of(const SearchPath& path) {
  std::string csv = "panel,parameter,iteration,value,best\n";
  for (std::size_t i = 0; i < path.parameters.size(); ++i) {
    const SearchedParameter& parameter = path.parameters[i];
    const auto add = [&](std::size_t iteration, double value, double best) {
      csv += io::csv_line({std::to_string(i + 1), parameter.name, std::to_string(iteration),
                           io::text_of(value), io::text_of(best)}) +
             "\n";
    };
    add(0, parameter.start, parameter.start);
    for (std::size_t k = 0; k < parameter.values.size(); ++k)
      add(k + 1, parameter.values[k], parameter.best[k]);
  }
  return csv;
}

// The panel of one parameter: its range, its start as a dashed line, the search and the best value.
std::string panel_of(const SearchedParameter& parameter, std::size_t number) {
  const double margin = kPathMargin * (parameter.to - parameter.from);
  return fmt::format(
      "set title {0}\n"
      "set yrange [{1:.6g}:{2:.6g}]\n"
      "set ytics {3:.6g}\n"
      "plot {4:.6g} with lines lc rgb '#777777' dt 2 title 'start', \\\n"
      "     data using (of({5}, 'iteration')):(of({5}, 'value')) with lines lw 1 lc rgb '{6}' "
      "title 'search', \\\n"
      "     data using (of({5}, 'iteration')):(of({5}, 'best')) with lines lw 2.5 lc rgb '{7}' "
      "title 'best known'\n"
      "unset key\n",
      script_text(shortened(parameter.name, kLongestName)), parameter.from - margin,
      parameter.to + margin, tic_step(parameter.to - parameter.from), parameter.start, number + 1,
      kBlue, kVermilion);
}

std::string script_of(const SearchPath& path, std::size_t panels) {
  const auto count = static_cast<int>(panels);
  const int height_px = kPathTop_px + kPathBottom_px + count * kPathPanel_px;
  std::string script =
      script_head("tuning_path", height_px) +
      fmt::format(
          "of(i, column_name) = column('panel') == i ? column(column_name) : NaN\n"
          "set tics font ',11'\n"
          "set title offset 0,-0.7\n"
          "set xrange [0:{0}]\n"
          "set format x ''\n"
          "set key at screen 0.97, screen 0.99 right top horizontal\n"
          "set multiplot layout {1},1 margins screen 0.09,0.97,{2:.4f},{3:.4f} spacing screen "
          "0,{4:.4f}\n",
          std::max(1, path.iterations), count, static_cast<double>(kPathBottom_px) / height_px,
          1 - static_cast<double>(kPathTop_px) / height_px,
          static_cast<double>(kPathBetween_px) / height_px);
  for (std::size_t i = 0; i < panels; ++i) {
    if (i + 1 == panels) script += "set format x\nset xlabel 'iteration'\n";
    script += panel_of(path.parameters[i], i);
  }
  return script + "unset multiplot\n";
}

}  // namespace

std::optional<Plot> tuning_path_plot(const ExperimentResults& results) {
  if (!results.search) return std::nullopt;
  const SearchPath& path = *results.search;
  if (path.parameters.empty() || path.parameters.front().values.empty()) return std::nullopt;
  const std::size_t panels = std::min(kMostPanels, path.parameters.size());
  Plot plot{"tuning_path",
            "Each tuned parameter by iteration, over its whole range: the search (thin), and the "
            "best value known at that iteration, which averages over the last half of the "
            "iterations so far (thick). The dashed line is the start. A search that wanders over "
            "the range without a trend has not found any effect of the parameter in these games.",
            csv_of(path), script_of(path, panels)};
  if (panels < path.parameters.size()) {
    plot.about += fmt::format(" Only the first {} of {} are drawn; the data file contains all.",
                              panels, path.parameters.size());
  }
  return plot;
}

}  // namespace autoref::experiments
