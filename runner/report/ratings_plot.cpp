#include <fmt/format.h>

#include <algorithm>

#include "runner/io/csv.hpp"
#include "runner/report/factor_axis.hpp"
#include "runner/report/plots.hpp"

namespace autoref::runner {
namespace {

constexpr int kRatingsFrameHeight_px = 90;
constexpr int kRatingsRowHeight_px = 32;
constexpr double kRatingsBottom_px = 72;  // below the panels

Cells cells_of(const Rating& rating) {
  const auto& [low, high] = bounds_of(rating.interval);
  return {number_cell(rating.value), number_cell(low), number_cell(high)};
}

std::string csv_of(const std::vector<Standing>& standings) {
  std::string csv =
      "rank,team,goals,goals_low95,goals_high95,bradley_terry,bradley_terry_low95,"
      "bradley_terry_high95\n";
  for (std::size_t i = 0; i < standings.size(); ++i) {
    Cells cells = {std::to_string(i + 1), standings[i].team};
    append(cells, cells_of(standings[i].goals));
    append(cells, cells_of(standings[i].strength));
    csv += csv_line(cells) + "\n";
  }
  return csv;
}

// Range of the ratings and their intervals, including zero.
double span_of(const std::vector<Standing>& standings, Rating Standing::*which) {
  Interval span;
  for (const Standing& standing : standings) {
    const Rating& rating = standing.*which;
    const Interval shown = rating.interval.value_or(Interval{rating.value, rating.value});
    span = {std::min({span.low, shown.low, rating.value}),
            std::max({span.high, shown.high, rating.value})};
  }
  return span.high > span.low ? span.high - span.low : 1;
}

// Fraction of the width taken by the team names to the left of the first panel.
double names_share(const std::vector<std::string>& teams) {
  std::size_t longest = 0;
  for (const std::string& team : teams) longest = std::max(longest, team.size());
  return 0.04 + 0.0095 * static_cast<double>(std::min(longest, kLongestLabel));
}

std::string panel(const char* column, const char* label, const char* colour, double span) {
  return fmt::format(
      "set xlabel '{1}'\n"
      "set xtics {3:.6g}\n"
      "plot data using '{0}':'rank':(0):'{0}':(column('rank') - 0.32):(column('rank') + 0.32) with "
      "boxxyerror fs solid 0.45 noborder lc rgb '{2}' notitle, \\\n"
      "     data using '{0}':'rank':'{0}_low95':'{0}_high95' with xerrorbars pt -1 lw 2 lc rgb "
      "'#333333' notitle\n",
      column, label, colour, tic_step(span));
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
             "set xrange [*<0:0<*]\n"
             "set arrow from first 0, graph 0 to first 0, graph 1 nohead lc rgb '#777777' front\n"
             "set multiplot layout 1,2 margins screen {:.4f},0.98,{:.4f},0.97 spacing screen "
             "0.04\n",
             teams.size(), names_share(teams), kRatingsBottom_px / height_px) +
         panel("goals", "goals per game above the average team", kBlue,
               span_of(standings, &Standing::goals)) +
         "unset ytics\n" +
         panel("bradley_terry", "Bradley-Terry strength", kVermilion,
               span_of(standings, &Standing::strength)) +
         "unset multiplot\n";
}

}  // namespace

std::optional<Plot> ratings_plot(const ExperimentResults& results) {
  if (!are_rated(results.standings) || !has_games(results.groups)) return std::nullopt;
  return Plot{
      "ratings",
      "Ratings of the teams, best first: in goals per game (least squares), and Bradley-Terry "
      "strength, where a beats b with probability 1 / (1 + exp(b - a)). The bars "
      "are 95 % intervals from resampled pairs of legs.",
      csv_of(results.standings), script_of(results.standings)};
}

}  // namespace autoref::runner
