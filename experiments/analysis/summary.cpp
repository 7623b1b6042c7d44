#include "experiments/analysis/summary.hpp"

#include <fmt/format.h>

#include "experiments/schedule/schedule.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/table.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

// The factors' paths, and the values of each group.
std::vector<io::Cells> rows_of_values(const std::vector<Factor>& factors,
                                      const std::vector<Group>& groups) {
  std::vector<io::Cells> rows(1);
  for (const Factor& factor : factors) rows.front().push_back(factor.path);
  for (const Group& group : groups) rows.push_back(group.values);
  return rows;
}

// The goal difference of one pair number at each value; nullopt if any is missing.
std::optional<std::vector<double>> differences_of(int pair, const std::vector<Group>& groups) {
  std::vector<double> differences;
  for (const Group& group : groups) {
    const auto found = group.pair_differences.find(pair);
    if (found == group.pair_differences.end()) return std::nullopt;
    differences.push_back(found->second);
  }
  return differences;
}

// The difference of each value from the first value; the first entry is empty.
std::vector<PairedDifference> differences_from_first(const std::vector<Group>& groups) {
  std::vector<DifferenceByPair> values;
  values.reserve(groups.size());
  for (const Group& group : groups) values.push_back(group.pair_differences);
  std::vector<PairedDifference> differences = differences_from_baseline(values);
  differences.insert(differences.begin(), PairedDifference{});
  return differences;
}

// "+2.10 [+1.50, +2.70]" and the corrected p, if there is one.
io::TableColumns<PairedDifference> difference_text_columns() {
  return {{"from the first [95 %]",
           [](const PairedDifference& from_first) {
             return from_first.mean
                        ? mean_text(*from_first.mean, from_first.interval, from_first.pairs)
                        : "";
           }},
          {"p", [](const PairedDifference& from_first) {
             return from_first.p_holm ? p_text(*from_first.p_holm) : "";
           }}};
}

}  // namespace

std::vector<Group> grouped(const std::vector<Factor>& factors, const RowsById& rows) {
  return grouped(
      game::spelt(combinations(factors)), [](const GameRow& row) { return row.values; }, rows);
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
  return Slope{mean(slopes), mean_interval(slopes), slopes.size()};
}

std::string summary_csv(const std::vector<Factor>& factors, const std::vector<Group>& groups) {
  std::vector<io::Cells> rows = rows_of_values(factors, groups);
  io::append_columns(rows, summary_columns(), groups);
  io::append_columns(rows, difference_columns("from_first", "from_first_"),
                     differences_from_first(groups));
  io::append_columns(rows, result_columns(), groups);
  return io::csv_text(rows);
}

std::vector<io::Cells> summary_rows(const std::vector<Factor>& factors,
                                    const std::vector<Group>& groups) {
  std::vector<io::Cells> rows = rows_of_values(factors, groups);
  io::append_columns(rows, text_columns(), groups);
  if (groups.size() > 1)
    io::append_columns(rows, difference_text_columns(), differences_from_first(groups));
  return rows;
}

std::string slope_text(const std::vector<Factor>& factors, const std::optional<Slope>& slope) {
  if (!slope) return {};
  const std::string text =
      fmt::format("a minus b changes by {:+.2f} per unit of {}", slope->mean, factors.front().path);
  if (!slope->interval) return text + "\n";
  return text + fmt::format(" (95 % interval {:+.2f} to {:+.2f})\n", slope->interval->low,
                            slope->interval->high);
}

io::TextBlocks summary_table(const std::vector<Factor>& factors, const std::vector<Group>& groups,
                             const std::optional<Slope>& slope) {
  io::TextBlocks blocks = {without_void_games({summary_rows(factors, groups), {}, factors.size()})};
  if (slope) blocks.emplace_back("\n" + slope_text(factors, slope));
  return blocks;
}

}  // namespace autoref::experiments
