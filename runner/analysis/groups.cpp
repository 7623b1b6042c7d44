#include "runner/analysis/groups.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runner/io/words.hpp"
#include "runner/results/scores.hpp"
#include "runner/statistics/mean_interval.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {
namespace {

void count_result(Group& group, double lead) {
  ++(lead > 0 ? group.wins_a : lead < 0 ? group.wins_b : group.draws);
}

// Whether a row holds the values in these columns.
bool has_values(const Cells& row, const std::vector<std::size_t>& columns, const Cells& values) {
  return std::equal(values.begin(), values.end(), columns.begin(), columns.end(),
                    [&row](const std::string& v, std::size_t column) { return v == row[column]; });
}

Group group_of(const Cells& values, const std::vector<std::size_t>& columns, const ScoreColumns& at,
               const std::vector<Cells>& rows) {
  Group group;
  group.values = values;
  for (const Cells& row : rows) {
    if (!has_values(row, columns, values)) continue;
    if (is_void(row, at)) {
      ++group.void_games;
      continue;
    }
    group.goals_a.push_back(number_in(row[at.goals_a]).value());
    group.goals_b.push_back(number_in(row[at.goals_b]).value());
    group.differences.push_back(group.goals_a.back() - group.goals_b.back());
    const double lead = lead_of_a(row, at);
    count_result(group, lead);
    const double win = lead > 0 ? 1 : lead < 0 ? 0 : 0.5;
    group.games_by_pair[row[at.pair]].push_back({group.differences.back(), win});
  }
  for (const auto& [number, legs] : group.games_by_pair) {
    if (legs.size() == 2)
      group.pair_differences[number] = (legs[0].difference + legs[1].difference) / 2;
  }
  return group;
}

std::optional<double> mean_of(const std::vector<double>& sample) {
  return sample.empty() ? std::nullopt : std::optional(mean(sample));
}

// "1.50 ± 1.00", the mean and the standard deviation; "-" where there are no games.
std::string score_text(const std::vector<double>& goals) {
  if (goals.empty()) return "-";
  const std::optional<double> deviation = standard_deviation(goals);
  return deviation ? fmt::format("{:.2f} ± {:.2f}", mean(goals), *deviation)
                   : fmt::format("{:.2f}", mean(goals));
}

}  // namespace

std::vector<Group> grouped(const std::vector<std::string>& columns,
                           const std::vector<std::vector<std::string>>& values,
                           const RowFormat& format, const std::vector<Cells>& rows) {
  const ScoreColumns at(format);
  std::vector<std::size_t> numbers;
  numbers.reserve(columns.size());
  for (const std::string& column : columns) numbers.push_back(format.column(column));
  std::vector<Group> groups;
  groups.reserve(values.size());
  for (const Cells& group : values) groups.push_back(group_of(group, numbers, at, rows));
  return groups;
}

std::vector<double> values_of(const std::map<std::string, double>& by_name) {
  std::vector<double> values;
  values.reserve(by_name.size());
  for (const auto& [name, value] : by_name) values.push_back(value);
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

Cells table_columns() { return {"games", "goals a", "goals b", "a minus b [95 %]", "void"}; }

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
