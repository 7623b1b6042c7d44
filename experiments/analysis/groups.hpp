// Scores of an experiment's games, grouped by a sweep's values or by matchup, and the columns that
// show them.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/results/game_row.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "experiments/statistics/rated_games.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {

// The interval's bounds; both are nullopt without an interval.
inline std::pair<std::optional<double>, std::optional<double>> bounds_of(
    const std::optional<Interval>& interval) {
  if (!interval) return {};
  return {interval->low, interval->high};
}

// The columns low95 and high95 of a 95 % interval, with a prefix such as "diff_".
template <typename Row>
io::TableColumns<Row> interval_columns(
    const std::string& prefix, const std::function<std::optional<Interval>(const Row&)>& interval,
    bool are_in_json = false) {
  return {{prefix + "low95", [interval](const Row& row) { return bounds_of(interval(row)).first; },
           are_in_json},
          {prefix + "high95",
           [interval](const Row& row) { return bounds_of(interval(row)).second; }, are_in_json}};
}

// Numbers of games won, drawn and lost.
using ResultCounts = std::array<int, 3>;

// The number of games with some result, and the number of all games.
struct ResultShare {
  int part = 0;
  int whole = 0;

  std::optional<double> fraction() const {
    return whole == 0 ? std::nullopt : std::optional(static_cast<double>(part) / whole);
  }
  std::optional<Interval> interval() const { return proportion_interval(part, whole); }
};

// Columns for the share of each of several whole-number columns in their sum: the fraction and its
// 95 % interval, such as "wins_a_share", "wins_a_low95" and "wins_a_high95". The intervals are
// those of proportion_interval(), which assumes independent games. The cells are empty if there are
// no games.
template <typename Row>
io::TableColumns<Row> share_columns(const io::TableColumns<Row>& counts) {
  io::TableColumns<Row> columns;
  for (const io::TableColumn<Row>& count : counts) {
    const auto share = [count, counts](const Row& row) {
      ResultShare of_count{std::get<int>(count.value(row))};
      for (const io::TableColumn<Row>& any : counts)
        of_count.whole += std::get<int>(any.value(row));
      return of_count;
    };
    const auto fraction = [share](const Row& row) { return share(row).fraction(); };
    const auto interval = [share](const Row& row) { return share(row).interval(); };
    columns = io::joined(columns, io::TableColumns<Row>{{count.name + "_share", fraction}},
                         interval_columns<Row>(count.name + "_", interval));
  }
  return columns;
}

// "63 % [52, 73]": the fraction with its 95 % interval; "-" if `whole` is 0.
std::string share_text(int part, int whole);

// The scores of all games with the same values. Void games count only in `void_games`.
struct Group {
  std::vector<std::string> values;
  std::vector<double> goals_a;  // goals of team a in each game
  std::vector<double> goals_b;
  std::vector<double> differences;  // goals of a minus goals of b
  // The mean goal difference over the two legs, by pair number. Pairs with a void leg are left out.
  DifferenceByPair pair_differences;
  // Rated games by pair number, without void games.
  std::map<int, std::vector<RatedGame>> games_by_pair;
  int void_games = 0;
  // Numbers of games that ended early because team a, or team b, led by enough goals.
  int lead_ends_a = 0;
  int lead_ends_b = 0;
  // Results according to lead_of_a() (game_row.hpp).
  int wins_a = 0;
  int draws = 0;
  int wins_b = 0;

  // Number of games that are not void.
  int games() const { return static_cast<int>(differences.size()); }
  int pairs() const { return static_cast<int>(pair_differences.size()); }
  ResultCounts results() const { return {wins_a, draws, wins_b}; }
};

// Groups the rows by `values_of(row)`. Returns one group per entry of `values`, in that order.
std::vector<Group> grouped(const std::vector<std::vector<std::string>>& values,
                           const std::function<std::vector<std::string>(const GameRow&)>& values_of,
                           const RowsById& rows);

// The mean; nullopt for an empty sample.
std::optional<double> mean_of(const std::vector<double>& sample);

// The differences in the order of the pair numbers.
std::vector<double> values_of(const DifferenceByPair& differences);

// A group's columns in summary.csv after its values: games, means and standard deviations (over
// games), and the 95 % interval of the mean difference (over pairs). Missing values are empty
// cells.
io::TableColumns<Group> summary_columns();

// Columns for the results: team a's wins, draws and losses, and their fractions of all games.
io::TableColumns<Group> result_columns();

// [{"values": ["1.0"], "games": 24, "void_games": 0, "mean_a": 4.54, "mean_b": 3.33,
//   "mean_diff": 1.21, "wins_a": 14, "draws": 2, "wins_b": 8}, ...], with values from the
//   columns of summary.csv. Means are null if there are no games.
io::Json json_of(const std::vector<Group>& groups);

// A group's columns in text tables: games, goals, mean goal difference with its interval, void
// games.
io::TableColumns<Group> text_columns();
inline constexpr const char* kGamesHead = "games";
inline constexpr const char* kGoalsAHead = "goals a";
inline constexpr const char* kGoalsBHead = "goals b";
inline constexpr const char* kDifferenceHead = "a minus b [95 %]";
inline constexpr const char* kVoidHead = "void";

// Removes the column of void games from the table if no game is void. Throws std::logic_error if it
// does not have that column.
io::TextTable without_void_games(io::TextTable table);

// The columns of a paired difference: its mean, interval, p value, corrected p value and effect
// size. `mean` is the name of the first column, and `prefix` precedes those of the interval.
io::TableColumns<PairedDifference> difference_columns(const std::string& mean,
                                                      const std::string& prefix);

// "+0.50 [-0.10, +1.10]": the mean goal difference over games, followed by its 95 % interval over
// pairs if known.
std::string difference_text(const std::vector<double>& differences,
                            const std::vector<double>& pair_differences);

// The mean with its interval, "+0.50 [-0.10, +1.10]"; if the interval has only one end,
// "+0.50 [at least -0.10]" or "+0.50 [at most +1.10]"; without an interval, "+0.50 (too few
// games)", or "+0.50 (all pairs equal)" if there are several `pairs`.
std::string mean_text(double mean, const std::optional<Interval>& interval, std::size_t pairs = 0);

// "0.032", or "<0.001".
std::string p_text(double p);

// A p value as a CSV cell, with six significant digits; empty if nullopt.
std::string p_cell(std::optional<double> p);

}  // namespace autoref::experiments
