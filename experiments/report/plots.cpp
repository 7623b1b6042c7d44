#include "experiments/report/plots.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>

#include "experiments/analysis/summary.hpp"
#include "experiments/report/group_names.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {
namespace {

constexpr int kHeight_px = 400;

std::string csv_of(const std::vector<Group>& groups) {
  std::string csv = "value,games,mean_a,sd_a,mean_b,sd_b\n";
  for (const Group& group : groups) {
    if (group.goals_a.empty()) continue;
    io::Cells cells = {group.values.front(), std::to_string(group.goals_a.size())};
    for (const auto* goals : {&group.goals_a, &group.goals_b}) {
      io::append(cells,
                 {io::number_cell(mean(*goals)), io::number_cell(standard_deviation(*goals))});
    }
    csv += io::csv_line(cells) + "\n";
  }
  return csv;
}

// Draws a team's points shifted sideways, so neither team's bars hide the other's.
std::string curve(char team, const char* colour, int point, char shift) {
  return fmt::format(
      "data using (column('value') {3} dodge):'mean_{0}':(low(column('mean_{0}'), "
      "column('sd_{0}'))):(column('mean_{0}') + column('sd_{0}')) with yerrorbars pt -1 lw 1.5 lc "
      "rgb '{1}' notitle, \\\n"
      "     data using (column('value') {3} dodge):'mean_{0}' with linespoints pt {2} ps 0.7 lw 2 "
      "lc rgb '{1}' title 'team {0}'",
      team, colour, point, shift);
}

std::string script_of(const NumericFactor& factor, const std::vector<Group>& groups) {
  return script_head("scores", kHeight_px) + factor_axis(factor, groups) +
         fmt::format(
             "set ylabel 'goals per game, mean and standard deviation'\n"
             "set yrange [0:*]\n"
             "set offsets 0, 0, graph 0.04, 0\n"
             "low(mean, deviation) = mean > deviation ? mean - deviation : 0\n"
             "set key top left reverse Left\n"
             "dodge = {}\n"
             "plot {}, \\\n     {}\n",
             dodge_of(factor), curve('a', kBlue, 7, factor.is_falling() ? '+' : '-'),
             curve('b', kVermilion, 5, factor.is_falling() ? '-' : '+'));
}

constexpr int kCurveHeight_px = 400;

constexpr const char* kWhatBarsAre =
    "bars: Student's 95 % intervals over pairs of legs. Above 0, team a is better.";

// `value` is the value of the factor, or else the number of the row.
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
                     mean_text(slope->mean, slope->interval, slope->pairs), factor);
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

constexpr int kHistogramFrameHeight_px = 90;
constexpr double kTallestBar = 0.85;  // fraction of a row's height

int bar_height_px(std::size_t rows) {
  return rows <= 3 ? 100 : rows <= 6 ? 60 : rows <= 12 ? 42 : 30;
}

using GamesByDifference = std::map<int, int>;

GamesByDifference counted(const Group& group) {
  GamesByDifference games;
  for (const double difference : group.differences) {
    ++games[static_cast<int>(std::lround(difference))];
  }
  return games;
}

std::string csv_rows(std::size_t row, const std::string& name, const GamesByDifference& counts) {
  int tallest = 0;
  for (const auto& [difference, games] : counts) tallest = std::max(tallest, games);
  std::string csv;
  for (const auto& [difference, games] : counts) {
    csv +=
        io::csv_line({std::to_string(row), name, std::to_string(difference), std::to_string(games),
                      io::number_cell(static_cast<double>(games) / tallest)}) +
        "\n";
  }
  return csv;
}

std::string script_of(const Scenario& scenario, const std::vector<std::string>& names) {
  const int rows = static_cast<int>(names.size());
  return script_head("histogram", kHistogramFrameHeight_px + rows * bar_height_px(names.size())) +
         script_tics("y", names) +
         fmt::format(
             "set ylabel {}\n"
             "set yrange [{}.1:0]\n"
             "set xlabel 'goals of a minus goals of b'\n"
             "set xrange [*<-0.5:0.5<*]\n"
             "set arrow from first 0, graph 0 to first 0, graph 1 nohead lc rgb '#777777' dt 2\n"
             "top(row, share) = row - {} * share\n"
             "plot data using 'goal_difference':'row':(column('goal_difference') - "
             "0.42):(column('goal_difference') + "
             "0.42):'row':(top(column('row'), column('share_of_tallest'))) with boxxyerror fs "
             "solid "
             "0.75 noborder lc rgb '{}' notitle\n",
             script_text(axis_name(scenario)), rows, kTallestBar, kBlue);
}

}  // namespace

std::vector<Plot> plots_of(const Scenario& scenario, const ExperimentResults& results) {
  std::vector<Plot> plots;
  for (const std::optional<Plot>& plot :
       {scores_plot(scenario, results), difference_plot(scenario, results), effects_plot(results),
        crosstable_plot(results), ratings_plot(results), versions_plot(results),
        histogram_plot(scenario, results), running_mean_plot(scenario, results),
        tuning_path_plot(results)}) {
    if (plot) plots.push_back(*plot);
  }
  return plots;
}

std::optional<Plot> scores_plot(const Scenario& scenario, const ExperimentResults& results) {
  const std::optional<NumericFactor> factor = numeric_factor(scenario, results.groups);
  if (!factor || !has_games(results.groups)) return std::nullopt;
  return Plot{"scores",
              fmt::format("Goals of both teams against {}: the mean over each value's games; bars "
                          "show the standard deviation of single games, not the uncertainty of "
                          "the mean, and end at 0, since no team has fewer goals. Same form as the "
                          "AutoRef paper's Fig. 5.",
                          factor->path),
              csv_of(results.groups), script_of(*factor, results.groups)};
}

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

std::optional<Plot> effects_plot(const ExperimentResults& results) {
  if (results.effects.empty()) return std::nullopt;
  Plot plot{"effects", "", "row,effect,pairs,mean_diff,low95,high95\n", ""};
  std::vector<std::string> names;
  for (const Effect& effect : results.effects) {
    names.push_back(effect_name(effect));
    const auto& [low, high] = bounds_of(effect.interval);
    plot.csv +=
        io::csv_line({std::to_string(names.size()), names.back(), std::to_string(effect.pairs),
                      io::number_cell(effect.mean), io::number_cell(low), io::number_cell(high)}) +
        "\n";
  }
  plot.about =
      "Effect of each value of a factor: the change of the mean goal difference from the factor's "
      "first value, averaged over the other factors. Effect of two values: how much one changes "
      "the effect of the other. Bars: Student's 95 % intervals over pairs of legs.";
  plot.about += note_of_cut(names.size());
  names.resize(std::min(names.size(), kMostGroupsInPlot));
  plot.script = interval_rows_script("effects", names, "effect",
                                     "change of a minus b in goals per game, 95 % interval");
  return plot;
}

std::optional<Plot> histogram_plot(const Scenario& scenario, const ExperimentResults& results) {
  if (!has_games(results.groups)) return std::nullopt;
  std::vector<std::string> names = names_of(scenario, results.groups);
  Plot plot{"histogram",
            "Number of games by goal difference; each row is scaled to its tallest bar.",
            "row,name,goal_difference,games,share_of_tallest\n", ""};
  for (std::size_t i = 0; i < names.size(); ++i) {
    plot.csv += csv_rows(i + 1, names[i], counted(results.groups[i]));
  }
  plot.about += note_of_cut(names.size());
  names.resize(std::min(names.size(), kMostGroupsInPlot));
  plot.script = script_of(scenario, names);
  return plot;
}

}  // namespace autoref::experiments
