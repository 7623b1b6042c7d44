#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "experiments/report/factor_axis.hpp"
#include "experiments/report/plots.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {
namespace {

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
