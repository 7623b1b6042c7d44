#include <fmt/format.h>

#include "experiments/report/factor_axis.hpp"
#include "experiments/report/plots.hpp"
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

}  // namespace

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

}  // namespace autoref::experiments
