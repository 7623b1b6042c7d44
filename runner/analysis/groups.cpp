#include "runner/analysis/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runner/results/scores.hpp"
#include "runner/statistics/mean_interval.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {
namespace {

void count_result(Group& group, double lead) {
  ++(lead > 0 ? group.wins_a : lead < 0 ? group.wins_b : group.draws);
}

void add_game(Group& group, const GameRow& row) {
  if (is_void(row.record)) {
    ++group.void_games;
    return;
  }
  group.goals_a.push_back(row.record.goals_a);
  group.goals_b.push_back(row.record.goals_b);
  group.differences.push_back(group.goals_a.back() - group.goals_b.back());
  const double lead = lead_of_a(row.record);
  count_result(group, lead);
  const double win = lead > 0 ? 1 : lead < 0 ? 0 : 0.5;
  group.games_by_pair[row.pair].push_back({group.differences.back(), win});
}

// Pairs with a missing leg are left out.
DifferenceByPair pair_differences_of(const Group& group) {
  DifferenceByPair differences;
  for (const auto& [number, legs] : group.games_by_pair) {
    // All tests use one value per pair, since the teams change sides between its legs.
    if (legs.size() == 2) differences[number] = (legs[0].difference + legs[1].difference) / 2;
  }
  return differences;
}

std::optional<double> mean_of(const std::vector<double>& sample) {
  return sample.empty() ? std::nullopt : std::optional(mean(sample));
}

// "1.50 ± 1.00": mean and standard deviation; "-" without games.
std::string score_text(const std::vector<double>& goals) {
  if (goals.empty()) return "-";
  const std::optional<double> deviation = standard_deviation(goals);
  return deviation ? fmt::format("{:.2f} ± {:.2f}", mean(goals), *deviation)
                   : fmt::format("{:.2f}", mean(goals));
}

}  // namespace

std::vector<Group> grouped(const std::vector<std::vector<std::string>>& values,
                           const std::function<std::vector<std::string>(const GameRow&)>& values_of,
                           const RowsById& rows) {
  std::vector<Group> groups(values.size());
  std::map<std::vector<std::string>, Group*> by_values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    groups[i].values = values[i];
    by_values[values[i]] = &groups[i];
  }
  for (const auto& [id, row] : rows) {
    const auto group = by_values.find(values_of(row));
    if (group != by_values.end()) add_game(*group->second, row);
  }
  for (Group& group : groups) group.pair_differences = pair_differences_of(group);
  return groups;
}

std::vector<double> values_of(const DifferenceByPair& differences) {
  std::vector<double> values;
  values.reserve(differences.size());
  for (const auto& [pair, value] : differences) values.push_back(value);
  return values;
}

Cells summary_columns() {
  return {"games",     "void_games", "mean_a", "sd_a",       "mean_b",     "sd_b",
          "mean_diff", "sd_diff",    "pairs",  "diff_low95", "diff_high95"};
}

Cells summary_cells(const Group& group) {
  Cells cells = {std::to_string(group.goals_a.size()), std::to_string(group.void_games)};
  for (const auto* sample : {&group.goals_a, &group.goals_b, &group.differences}) {
    cells.push_back(number_cell(mean_of(*sample)));
    cells.push_back(number_cell(standard_deviation(*sample)));
  }
  cells.push_back(std::to_string(group.pair_differences.size()));
  const auto& [low, high] = bounds_of(mean_interval(values_of(group.pair_differences)));
  append(cells, {number_cell(low), number_cell(high)});
  return cells;
}

Cells table_columns() { return {"games", "goals a", "goals b", "a minus b [95 %]", kVoidHead}; }

TextTable without_void_games(TextTable table) {
  const Cells& head = table.rows.front();
  const auto found = std::find(head.begin(), head.end(), kVoidHead);
  if (found == head.end()) return table;
  const auto column = static_cast<std::size_t>(found - head.begin());
  return without_zeros(std::move(table), column);
}

Cells table_cells(const Group& group) {
  return {std::to_string(group.goals_a.size()), score_text(group.goals_a),
          score_text(group.goals_b),
          difference_text(group.differences, values_of(group.pair_differences)),
          std::to_string(group.void_games)};
}

std::string difference_text(const std::vector<double>& differences,
                            const std::vector<double>& pair_differences) {
  if (differences.empty()) return "-";
  return mean_text(mean(differences), mean_interval(pair_differences));
}

std::string mean_text(double mean, const std::optional<Interval>& interval) {
  if (!interval) return fmt::format("{:+.2f} (too few games)", mean);
  if (std::isinf(interval->high)) {
    return fmt::format("{:+.2f} [at least {:+.2f}]", mean, interval->low);
  }
  if (std::isinf(interval->low)) {
    return fmt::format("{:+.2f} [at most {:+.2f}]", mean, interval->high);
  }
  return fmt::format("{:+.2f} [{:+.2f}, {:+.2f}]", mean, interval->low, interval->high);
}

std::string p_text(double p) { return p < 0.001 ? "<0.001" : fmt::format("{:.3f}", p); }

std::pair<std::optional<double>, std::optional<double>> bounds_of(
    const std::optional<Interval>& interval) {
  if (!interval) return {};
  return {interval->low, interval->high};
}

std::string p_cell(std::optional<double> p) { return p ? fmt::format("{:.6g}", *p) : ""; }

std::string number_cell(std::optional<double> number) {
  return number ? fmt::format("{:.4f}", *number) : "";
}

}  // namespace autoref::runner
