#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/report/crosstable.hpp"
#include "experiments/report/factor_axis.hpp"
#include "experiments/report/plots.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {
namespace {

constexpr int kCrosstableFrameHeight_px = 130;
constexpr std::size_t kMostTeams = 30;  // with more, the numbers would be unreadable

int row_height_px(std::size_t teams) { return teams <= 6 ? 56 : teams <= 12 ? 40 : 26; }

// Font size by number of teams.
const char* number_font(std::size_t teams) {
  return teams <= 10 ? ",13" : teams <= 18 ? ",10" : ",8";
}
const char* number_format(std::size_t teams) { return teams <= 12 ? "%+.2f" : "%+.1f"; }

template <typename Do>
void for_each_result(const Crosstable& table, const Do& work) {
  for (std::size_t row = 0; row < table.teams.size(); ++row) {
    for (std::size_t column = 0; column < table.teams.size(); ++column) {
      const std::optional<CrossCell>& cell = table.cells[row][column];
      if (cell && cell->mean_difference) work(row, column, *cell);
    }
  }
}

std::string csv_of(const Crosstable& table) {
  std::string csv = "row,column,team,opponent,wins,draws,losses,mean_diff\n";
  for_each_result(table, [&](std::size_t row, std::size_t column, const CrossCell& cell) {
    csv += io::csv_line({std::to_string(row + 1), std::to_string(column + 1), table.teams[row],
                         table.teams[column], std::to_string(cell.wins), std::to_string(cell.draws),
                         std::to_string(cell.losses), io::number_cell(cell.mean_difference)}) +
           "\n";
  });
  return csv;
}

// Colour range: the largest square root of a difference, which keeps small differences visible.
// White is 0, and the range is symmetric.
double reach_of(const Crosstable& table) {
  double reach = 0;
  for_each_result(table, [&reach](std::size_t, std::size_t, const CrossCell& cell) {
    reach = std::max(reach, std::sqrt(std::abs(*cell.mean_difference)));
  });
  return reach > 0 ? reach : 1;
}

std::string script_of(const Crosstable& table) {
  const std::size_t teams = table.teams.size();
  return script_head("crosstable",
                     kCrosstableFrameHeight_px + static_cast<int>(teams) * row_height_px(teams)) +
         script_tics("y", table.teams) + script_tics("x", table.teams) +
         fmt::format(
             "unset grid\n"
             "set border 0\n"
             "set tics scale 0\n"
             "set xtics rotate by -30\n"
             "set xrange [0.5:{0}.5]\n"
             "set yrange [{0}.5:0.5]\n"
             "set cbrange [{1:.4f}:{2:.4f}]\n"
             "unset colorbox\n"
             "set palette defined (-1 '#f1a25f', 0 '#ffffff', 1 '#6fb1dc')\n"
             "set style fill solid 1.0 noborder\n"
             "colour(difference) = sgn(difference) * sqrt(abs(difference))\n"
             "plot data using 'column':'row':(column('column') - 0.5):(column('column') + "
             "0.5):(column('row') - 0.5):(column('row') + 0.5):(colour(column('mean_diff'))) with "
             "boxxyerror lc "
             "palette notitle, \\\n"
             "     data using 'column':'row':(sprintf('{3}', column('mean_diff'))) with labels "
             "font "
             "'{4}' notitle\n",
             teams, -reach_of(table), reach_of(table), number_format(teams), number_font(teams));
}

}  // namespace

std::optional<Plot> crosstable_plot(const ExperimentResults& results) {
  const std::optional<Crosstable> table = crosstable_of(results);
  if (!table || !has_games(results.groups) || table->teams.size() > kMostTeams) return std::nullopt;
  return Plot{
      "crosstable",
      "Mean goal difference of each row's team against each column's, best team first. Blue: "
      "the row's team is better.",
      csv_of(*table), script_of(*table)};
}

}  // namespace autoref::experiments
