#include "runner/summary.hpp"

#include <fmt/format.h>

#include "runner/csv.hpp"
#include "runner/statistics/mean_interval.hpp"
#include "runner/statistics/sample.hpp"
#include "runner/table.hpp"
#include "runner/words.hpp"

namespace autoref::runner {
namespace {

Cells factor_paths(const Sweep& sweep) {
  Cells paths;
  for (const Factor& factor : sweep.factors) paths.push_back(factor.path);
  return paths;
}

// The differences of one pair number, value by value; none unless every value has them.
std::optional<std::vector<double>> differences_of(const std::string& pair,
                                                  const std::vector<Group>& groups) {
  std::vector<double> differences;
  for (const Group& group : groups) {
    const auto found = group.pair_differences.find(pair);
    if (found == group.pair_differences.end()) return std::nullopt;
    differences.push_back(found->second);
  }
  return differences;
}

}  // namespace

std::vector<Group> grouped(const Sweep& sweep, const RowFormat& format,
                           const std::vector<Cells>& rows) {
  return grouped(factor_paths(sweep), combinations(sweep.factors), format, rows);
}

std::optional<Slope> slope_over_factor(const Sweep& sweep, const std::vector<Group>& groups) {
  if (sweep.factors.size() != 1 || groups.empty()) return std::nullopt;
  std::vector<double> values;
  for (const Group& group : groups) {
    const std::optional<double> value = number_in(group.values.front());
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  std::vector<double> slopes;
  for (const auto& [pair, first] : groups.front().pair_differences) {
    const std::optional<std::vector<double>> differences = differences_of(pair, groups);
    if (!differences) continue;
    const std::optional<double> slope = slope_of(values, *differences);
    if (slope) slopes.push_back(*slope);
  }
  if (slopes.empty()) return std::nullopt;
  return Slope{mean(slopes), mean_interval(slopes)};
}

std::string summary_csv(const Sweep& sweep, const std::vector<Group>& groups) {
  Cells columns = factor_paths(sweep);
  append(columns, summary_columns());
  std::string csv = csv_line(columns) + "\n";
  for (const Group& group : groups) {
    Cells cells = group.values;
    append(cells, summary_cells(group));
    csv += csv_line(cells) + "\n";
  }
  return csv;
}

std::string summary_table(const Sweep& sweep, const std::vector<Group>& groups) {
  std::vector<Cells> rows = {factor_paths(sweep)};
  append(rows.front(), table_columns());
  for (const Group& group : groups) {
    rows.push_back(group.values);
    append(rows.back(), table_cells(group));
  }
  std::string table = aligned(rows);
  const std::optional<Slope> slope = slope_over_factor(sweep, groups);
  if (slope) {
    table += fmt::format("\na minus b changes by {:+.2f} per unit of {}", slope->mean,
                         sweep.factors.front().path);
    if (slope->interval) {
      table += fmt::format(" (95 % interval {:+.2f} to {:+.2f})", slope->interval->low,
                           slope->interval->high);
    }
    table += '\n';
  }
  return table;
}

}  // namespace autoref::runner
