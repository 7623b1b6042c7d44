#include <fmt/format.h>

#include "experiments/analysis/summary.hpp"
#include "experiments/report/factor_axis.hpp"
#include "experiments/report/plots.hpp"
#include "experiments/statistics/mean_interval.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {
namespace {

constexpr int kCurveHeight_px = 400;

constexpr const char* kWhatBarsAre =
    "bars: Student's 95 % intervals over pairs of legs. Above 0, team a is better.";

// `value` is the value of the factor, or the row's number.
std::string csv_of(const std::vector<Group>& groups, const std::vector<std::string>& names,
                   bool has_factor) {
  std::string csv = has_factor ? "value,pairs,mean_diff,low95,high95\n"
                               : "row,name,pairs,mean_diff,low95,high95\n";
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Group& group = groups[i];
    if (group.differences.empty()) continue;
    const auto& [low, high] = bounds_of(mean_interval(values_of(group.pair_differences)));
    io::Cells cells = has_factor ? group.values : io::Cells{std::to_string(i + 1), names[i]};
    io::append(cells, {std::to_string(group.pair_differences.size()),
                       io::number_cell(mean(group.differences)), io::number_cell(low),
                       io::number_cell(high)});
    csv += io::csv_line(cells) + "\n";
  }
  return csv;
}

std::string slope_text(const std::optional<Slope>& slope, const std::string& factor) {
  if (!slope) return "";
  return fmt::format(" Slope: {} goals per game per unit of {}.",
                     mean_text(slope->mean, slope->interval), factor);
}

std::string curve_script(const NumericFactor& factor, const std::vector<Group>& groups) {
  return script_head("difference", kCurveHeight_px) + factor_axis(factor, groups) +
         fmt::format(
             "set ylabel 'goals of a minus goals of b, 95 % interval'\n"
             "set yrange [*<0:0<*]\n"
             "plot data using 'value':'low95':'high95' with filledcurves lc rgb '{0}' fs "
             "transparent solid 0.15 notitle, \\\n"
             "     0 with lines lc rgb '#777777' dt 2 notitle, \\\n"
             "     data using 'value':'mean_diff':'low95':'high95' with yerrorbars pt -1 lw 1.5 lc "
             "rgb '{0}' notitle, \\\n"
             "     data using 'value':'mean_diff' with linespoints pt 7 ps 0.7 lw 2 lc rgb '{0}' "
             "notitle\n",
             kBlue);
}

}  // namespace

std::optional<Plot> difference_plot(const Scenario& scenario, const ExperimentResults& results) {
  const std::vector<Group>& groups = results.groups;
  if (!has_games(groups)) return std::nullopt;
  std::vector<std::string> names = names_of(scenario, groups);
  Plot plot{"difference", "", csv_of(groups, names, false), ""};
  if (const auto factor = numeric_factor(scenario, groups)) {
    plot.about = fmt::format("Mean goal difference against {}; {}{}", factor->path, kWhatBarsAre,
                             slope_text(results.slope, factor->path));
    plot.csv = csv_of(groups, names, true);
    plot.script = curve_script(*factor, groups);
    return plot;
  }
  plot.about = fmt::format("Mean goal difference of each {}; {}",
                           scenario.experiment().value_columns().empty() ? "matchup" : "value",
                           kWhatBarsAre);
  plot.about += note_of_cut(names.size());
  names.resize(std::min(names.size(), kMostGroupsInPlot));
  plot.script = interval_rows_script("difference", names, axis_name(scenario),
                                     "goals of a minus goals of b, 95 % interval");
  return plot;
}

}  // namespace autoref::experiments
