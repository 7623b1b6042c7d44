#include "runner/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "runner/csv.hpp"
#include "runner/words.hpp"

namespace autoref::runner {
namespace {

// Sums the differences of a pair's legs.
struct Pair {
  double sum = 0;
  int legs = 0;
};

std::string text(std::optional<double> number) {
  return number ? fmt::format("{:.4f}", *number) : "";
}

std::optional<double> mean_of(const std::vector<double>& sample) {
  return sample.empty() ? std::nullopt : std::optional(mean(sample));
}

std::vector<double> values_of(const std::map<std::string, double>& by_name) {
  std::vector<double> values;
  values.reserve(by_name.size());
  for (const auto& [name, value] : by_name) values.push_back(value);
  return values;
}

Cells summary_cells(const Group& group) {
  Cells cells = group.values;
  cells.push_back(std::to_string(group.goals_a.size()));
  cells.push_back(std::to_string(group.void_games));
  for (const auto* sample : {&group.goals_a, &group.goals_b, &group.differences}) {
    cells.push_back(text(mean_of(*sample)));
    cells.push_back(text(standard_deviation(*sample)));
  }
  cells.push_back(std::to_string(group.pair_differences.size()));
  const std::optional<Interval> interval = mean_interval(values_of(group.pair_differences));
  cells.push_back(text(interval ? std::optional(interval->low) : std::nullopt));
  cells.push_back(text(interval ? std::optional(interval->high) : std::nullopt));
  return cells;
}

std::string score_text(const std::vector<double>& sample) {
  if (sample.empty()) return "-";
  const std::optional<double> deviation = standard_deviation(sample);
  return deviation ? fmt::format("{:.2f} ± {:.2f}", mean(sample), *deviation)
                   : fmt::format("{:.2f}", mean(sample));
}

std::string difference_text(const Group& group) {
  if (group.differences.empty()) return "-";
  const std::optional<Interval> interval = mean_interval(values_of(group.pair_differences));
  std::string text = fmt::format("{:+.2f}", mean(group.differences));
  if (interval) text += fmt::format(" [{:+.2f}, {:+.2f}]", interval->low, interval->high);
  return text;
}

Cells table_cells(const Group& group) {
  Cells cells = group.values;
  cells.push_back(std::to_string(group.goals_a.size()));
  cells.push_back(score_text(group.goals_a));
  cells.push_back(score_text(group.goals_b));
  cells.push_back(difference_text(group));
  cells.push_back(std::to_string(group.void_games));
  return cells;
}

// Letters, not bytes: of UTF-8 only first bytes count.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

std::string aligned(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += std::string(widths[i] - width_of(row[i]) + (i == 0 ? 0 : 3), ' ') + row[i];
    }
    text += '\n';
  }
  return text;
}

Cells factor_paths(const Sweep& sweep) {
  Cells paths;
  for (const Factor& factor : sweep.factors) paths.push_back(factor.path);
  return paths;
}

// Whether a row holds the values in the factors' columns.
bool has_values(const Cells& row, const std::vector<std::size_t>& columns, const Cells& values) {
  return std::equal(values.begin(), values.end(), columns.begin(), columns.end(),
                    [&row](const std::string& v, std::size_t column) { return v == row[column]; });
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
  const std::size_t goals_a = format.column("goals_a");
  const std::size_t goals_b = format.column("goals_b");
  const std::size_t status = format.column("status");
  const std::size_t pair_column = format.column("pair");
  std::vector<std::size_t> columns;
  for (const Factor& factor : sweep.factors) columns.push_back(format.column(factor.path));
  std::vector<Group> groups;
  for (const Cells& values : combinations(sweep.factors)) {
    Group group{values, {}, {}, {}, {}, 0};
    std::map<std::string, Pair> pairs;
    for (const Cells& row : rows) {
      if (!has_values(row, columns, values)) continue;
      if (row[status] == name_of(Status::kVoid)) {
        ++group.void_games;
        continue;
      }
      group.goals_a.push_back(number_in(row[goals_a]).value());
      group.goals_b.push_back(number_in(row[goals_b]).value());
      group.differences.push_back(group.goals_a.back() - group.goals_b.back());
      Pair& pair = pairs[row[pair_column]];
      pair.sum += group.differences.back();
      ++pair.legs;
    }
    for (const auto& [number, pair] : pairs) {
      if (pair.legs == 2) group.pair_differences[number] = pair.sum / 2;
    }
    groups.push_back(std::move(group));
  }
  return groups;
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
  columns.insert(columns.end(), {"games", "void_games", "mean_a", "sd_a", "mean_b", "sd_b",
                                 "mean_diff", "sd_diff", "pairs", "diff_low95", "diff_high95"});
  std::string csv = csv_line(columns) + "\n";
  for (const Group& group : groups) csv += csv_line(summary_cells(group)) + "\n";
  return csv;
}

std::string summary_table(const Sweep& sweep, const std::vector<Group>& groups) {
  Cells columns = factor_paths(sweep);
  columns.insert(columns.end(), {"games", "goals a", "goals b", "a minus b [95 %]", "void"});
  std::vector<Cells> rows = {columns};
  for (const Group& group : groups) rows.push_back(table_cells(group));
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
