#include "experiments/report/standings_plots.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "experiments/report/group_names.hpp"
#include "experiments/report/plots.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {
namespace {

CrossCell cell_of_a(const Group& group) {
  CrossCell cell{group.wins_a, group.draws, group.wins_b, {}};
  if (!group.differences.empty()) cell.mean_difference = mean(group.differences);
  return cell;
}

CrossCell from_other_side(const CrossCell& cell) {
  CrossCell other{cell.losses, cell.draws, cell.wins, {}};
  // Avoid -0, which would be printed with a minus sign.
  if (cell.mean_difference) other.mean_difference = 0 - *cell.mean_difference;
  return other;
}

std::optional<std::size_t> rank_of(const Crosstable& table, const std::string& team) {
  const auto found = std::find(table.teams.begin(), table.teams.end(), team);
  if (found == table.teams.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.teams.begin());
}

constexpr int kCrosstableFrameHeight_px = 130;
constexpr std::size_t kMostTeams = 30;  // more would make the numbers unreadable

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

// The colour range: the largest square root of a difference (the root keeps small differences
// visible). The range is symmetric, with white for 0.
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

constexpr int kRatingsFrameHeight_px = 90;
constexpr int kRatingsRowHeight_px = 32;
constexpr double kRatingsBottom_px = 72;  // space below the panels
constexpr double kEdgeShare = 0.08;       // fraction of the span left free on either side

io::Cells cells_of(const Rating& rating) {
  const auto& [low, high] = bounds_of(rating.interval);
  return {io::number_cell(rating.value), io::number_cell(low), io::number_cell(high)};
}

std::string csv_of(const std::vector<Standing>& standings) {
  std::string csv =
      "rank,team,goals,goals_low95,goals_high95,bradley_terry,bradley_terry_low95,"
      "bradley_terry_high95\n";
  for (std::size_t i = 0; i < standings.size(); ++i) {
    io::Cells cells = {std::to_string(i + 1), standings[i].team};
    io::append(cells, cells_of(standings[i].goals));
    io::append(cells, cells_of(standings[i].strength));
    csv += io::csv_line(cells) + "\n";
  }
  return csv;
}

// One panel of the plot.
struct RatingPanel {
  Rating Standing::*rating;
  const char* column;
  const char* label;
  const char* colour;
};

constexpr RatingPanel kGoalsPanel = {&Standing::goals, "goals",
                                     "goals per game above the average team", kBlue};
constexpr RatingPanel kStrengthPanel = {&Standing::strength, "bradley_terry",
                                        "Bradley-Terry strength", kVermilion};

// The range that the panel must show: zero, the ratings and the ends of their intervals.
struct ShownSpan {
  Interval span;
  bool has_open_end = false;
};

ShownSpan shown_in(const std::vector<Standing>& standings, const RatingPanel& panel) {
  ShownSpan shown;
  for (const Standing& standing : standings) {
    const Rating& rating = standing.*panel.rating;
    const Interval ends = rating.interval.value_or(Interval{rating.value, rating.value});
    for (const double end : {rating.value, ends.low, ends.high}) {
      shown.has_open_end |= std::isinf(end);
      if (std::isinf(end)) continue;
      shown.span = {std::min(shown.span.low, end), std::max(shown.span.high, end)};
    }
  }
  if (!(shown.span.low < shown.span.high)) shown.span.high = shown.span.low + 1;
  return shown;
}

// Fraction of the width taken by the team names to the left of the first panel.
double names_share(const std::vector<std::string>& teams) {
  std::size_t longest = 0;
  for (const std::string& team : teams) longest = std::max(longest, team.size());
  return 0.04 + 0.0095 * static_cast<double>(std::min(longest, kLongestLabel));
}

// Bars of intervals with an open end run to the edge of the panel and have an arrow there.
std::string open_bars(const RatingPanel& panel, const Interval& edges) {
  return fmt::format(
      "     data using (column('{0}_high95') > 1e300 ? column('{0}_low95') : NaN):'rank':"
      "({2:.6g} - column('{0}_low95')):(0) with vectors head filled lw 2 lc rgb '#333333' "
      "notitle, \\\n"
      "     data using (column('{0}_low95') < -1e300 ? column('{0}_high95') : NaN):'rank':"
      "({1:.6g} - column('{0}_high95')):(0) with vectors head filled lw 2 lc rgb '#333333' "
      "notitle, \\\n",
      panel.column, edges.low, edges.high);
}

std::string panel_script(const std::vector<Standing>& standings, const RatingPanel& panel) {
  const ShownSpan shown = shown_in(standings, panel);
  const double span = shown.span.high - shown.span.low;
  const Interval edges{shown.span.low - kEdgeShare * span, shown.span.high + kEdgeShare * span};
  return fmt::format(
      "set xlabel '{1}'\n"
      "set xtics {3:.6g}\n"
      "set xrange {4}\n"
      "plot data using '{0}':'rank':(0):'{0}':(column('rank') - 0.32):(column('rank') + 0.32) with "
      "boxxyerror fs solid 0.45 noborder lc rgb '{2}' notitle, \\\n"
      "{5}"
      "     data using '{0}':'rank':'{0}_low95':'{0}_high95' with xerrorbars pt -1 lw 2 lc rgb "
      "'#333333' notitle\n",
      panel.column, panel.label, panel.colour, tic_step(span),
      shown.has_open_end ? fmt::format("[{:.6g}:{:.6g}]", edges.low, edges.high) : "[*<0:0<*]",
      shown.has_open_end ? open_bars(panel, edges) : "");
}

std::string script_of(const std::vector<Standing>& standings) {
  std::vector<std::string> teams;
  teams.reserve(standings.size());
  for (const Standing& standing : standings) teams.push_back(standing.team);
  const int height_px =
      kRatingsFrameHeight_px + kRatingsRowHeight_px * static_cast<int>(teams.size());
  return script_head("ratings", height_px) + script_tics("y", teams) +
         fmt::format(
             "set yrange [{}.6:0.4]\n"
             "set arrow from first 0, graph 0 to first 0, graph 1 nohead lc rgb '#777777' front\n"
             "set multiplot layout 1,2 margins screen {:.4f},0.98,{:.4f},0.97 spacing screen "
             "0.04\n",
             teams.size(), names_share(teams), kRatingsBottom_px / height_px) +
         panel_script(standings, kGoalsPanel) + "unset ytics\n" +
         panel_script(standings, kStrengthPanel) + "unset multiplot\n";
}

}  // namespace

std::optional<Crosstable> crosstable_of(const ExperimentResults& results) {
  Crosstable table;
  for (const Standing& standing : results.standings) table.teams.push_back(standing.team);
  if (table.teams.size() < 2) return std::nullopt;
  table.cells.assign(table.teams.size(), std::vector<std::optional<CrossCell>>(table.teams.size()));
  for (const Group& group : results.groups) {
    if (group.values.size() != 2) return std::nullopt;
    const std::optional<std::size_t> a = rank_of(table, group.values[0]);
    const std::optional<std::size_t> b = rank_of(table, group.values[1]);
    if (!a || !b || *a == *b) return std::nullopt;
    table.cells[*a][*b] = cell_of_a(group);
    table.cells[*b][*a] = from_other_side(*table.cells[*a][*b]);
  }
  return table;
}

std::optional<Plot> crosstable_plot(const ExperimentResults& results) {
  const std::optional<Crosstable> table = crosstable_of(results);
  if (!table || !has_games(results.groups) || table->teams.size() > kMostTeams) return std::nullopt;
  return Plot{
      "crosstable",
      "Mean goal difference of each row's team against each column's, best team first. Blue: "
      "the row's team is better.",
      csv_of(*table), script_of(*table)};
}

std::optional<Plot> ratings_plot(const ExperimentResults& results) {
  if (!are_rated(results.standings) || !has_games(results.groups)) return std::nullopt;
  return Plot{
      "ratings",
      "Ratings of the teams, best first: in goals per game (least squares), and Bradley-Terry "
      "strength, where a beats b with probability 1 / (1 + exp(b - a)). The bars "
      "are 95 % intervals: from resampled pairs of legs, and from the profile of the likelihood. A "
      "bar with an arrow has no end there: the team won, or lost, all its games.",
      csv_of(results.standings), script_of(results.standings)};
}

}  // namespace autoref::experiments
