#include "runner/analysis/summary.hpp"

#include <fmt/format.h>

#include "runner/experiments/schedule.hpp"
#include "runner/io/csv.hpp"
#include "runner/io/table.hpp"
#include "runner/statistics/mean_interval.hpp"
#include "runner/statistics/paired_difference.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {
namespace {

Cells factor_paths(const std::vector<Factor>& factors) {
  Cells paths;
  for (const Factor& factor : factors) paths.push_back(factor.path);
  return paths;
}

// One pair number's difference at each value; nullopt if any is missing.
std::optional<std::vector<double>> differences_of(int pair, const std::vector<Group>& groups) {
  std::vector<double> differences;
  for (const Group& group : groups) {
    const auto found = group.pair_differences.find(pair);
    if (found == group.pair_differences.end()) return std::nullopt;
    differences.push_back(found->second);
  }
  return differences;
}

// Each value's difference from the first value; the first entry is empty.
std::vector<PairedDifference> differences_from_first(const std::vector<Group>& groups) {
  std::vector<DifferenceByPair> values;
  values.reserve(groups.size());
  for (const Group& group : groups) values.push_back(group.pair_differences);
  std::vector<PairedDifference> differences = differences_from_baseline(values);
  differences.insert(differences.begin(), PairedDifference{});
  return differences;
}

Cells difference_columns() {
  return {"from_first", "from_first_low95", "from_first_high95", "p", "p_holm", "effect_size"};
}

Cells difference_cells(const PairedDifference& from_first) {
  const auto& [low, high] = bounds_of(from_first.interval);
  return {
      number_cell(from_first.mean), number_cell(low),          number_cell(high),
      p_cell(from_first.p),         p_cell(from_first.p_holm), number_cell(from_first.effect_size)};
}

// "+2.10 [+1.50, +2.70]" and the corrected p, if there is one.
Cells difference_texts(const PairedDifference& from_first) {
  if (!from_first.mean) return {"", ""};
  return {mean_text(*from_first.mean, from_first.interval),
          from_first.p_holm ? p_text(*from_first.p_holm) : ""};
}

}  // namespace

std::vector<Group> grouped(const std::vector<Factor>& factors, const RowsById& rows) {
  return grouped(
      spelt(combinations(factors)), [](const GameRow& row) { return row.values; }, rows);
}

std::optional<Slope> slope_over_factor(const std::vector<Factor>& factors,
                                       const std::vector<Group>& groups) {
  if (factors.size() != 1) return std::nullopt;
  const std::optional<std::vector<double>> values = numbers_of(factors.front());
  if (!values) return std::nullopt;
  std::vector<double> slopes;
  for (const auto& [pair, first] : groups.front().pair_differences) {
    const std::optional<std::vector<double>> differences = differences_of(pair, groups);
    if (!differences) continue;
    const std::optional<double> slope = slope_of(*values, *differences);
    if (slope) slopes.push_back(*slope);
  }
  if (slopes.empty()) return std::nullopt;
  return Slope{mean(slopes), mean_interval(slopes)};
}

std::string summary_csv(const std::vector<Factor>& factors, const std::vector<Group>& groups) {
  Cells columns = factor_paths(factors);
  append(columns, summary_columns());
  append(columns, difference_columns());
  append(columns, result_columns());
  std::string csv = csv_line(columns) + "\n";
  const std::vector<PairedDifference> from_first = differences_from_first(groups);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Cells cells = groups[i].values;
    append(cells, summary_cells(groups[i]));
    append(cells, difference_cells(from_first[i]));
    append(cells, share_cells(groups[i].results()));
    csv += csv_line(cells) + "\n";
  }
  return csv;
}

std::vector<Cells> summary_rows(const std::vector<Factor>& factors,
                                const std::vector<Group>& groups) {
  std::vector<Cells> rows = {factor_paths(factors)};
  append(rows.front(), table_columns());
  if (groups.size() > 1) append(rows.front(), {"from the first [95 %]", "p"});
  const std::vector<PairedDifference> from_first = differences_from_first(groups);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    rows.push_back(groups[i].values);
    append(rows.back(), table_cells(groups[i]));
    if (groups.size() > 1) append(rows.back(), difference_texts(from_first[i]));
  }
  return rows;
}

std::string slope_text(const std::vector<Factor>& factors, const std::vector<Group>& groups) {
  const std::optional<Slope> slope = slope_over_factor(factors, groups);
  if (!slope) return {};
  const std::string text =
      fmt::format("a minus b changes by {:+.2f} per unit of {}", slope->mean, factors.front().path);
  if (!slope->interval) return text + "\n";
  return text + fmt::format(" (95 % interval {:+.2f} to {:+.2f})\n", slope->interval->low,
                            slope->interval->high);
}

TextBlocks summary_table(const std::vector<Factor>& factors, const std::vector<Group>& groups) {
  TextBlocks blocks = {without_void_games({summary_rows(factors, groups), {}, factors.size()})};
  const std::string slope = slope_text(factors, groups);
  if (!slope.empty()) blocks.emplace_back("\n" + slope);
  return blocks;
}

}  // namespace autoref::runner
