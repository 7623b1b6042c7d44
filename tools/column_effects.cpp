// Compares columns of a sweep's results.csv between the values of one factor:
//
//     column_effects RESULTS.CSV FACTOR SUM ...
//
// A SUM is a column, several columns joined by +, or a prefix followed by *, such as calls_*.
// Prints a row of Markdown for each combination of the other factors and each sum: its mean per
// game with each value of the factor, the change from the first value with its 95 % interval, and
// the p value of the paired t test, with Holm's correction over the table. Pairs with the same
// number have the same seeds, so they are compared pair by pair. The exit code is 2 if the file or
// an argument is wrong.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/statistics/paired_difference.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/csv.hpp"
#include "io/files.hpp"
#include "io/words.hpp"

namespace autoref::tools {
namespace {

struct Table {
  io::Cells head;
  std::vector<io::Cells> rows;

  std::size_t column(const std::string& name) const {
    const auto at = std::find(head.begin(), head.end(), name);
    if (at == head.end()) throw std::invalid_argument(fmt::format("there is no column {}", name));
    return static_cast<std::size_t>(at - head.begin());
  }
};

// Throws std::invalid_argument if a game does not count.
Table read_table(const std::string& path) {
  const std::string text = io::read_user_file(path);
  Table table;
  for (const std::string_view line : io::complete_lines(text)) {
    io::Cells cells = io::csv_cells(line).value();
    if (table.head.empty()) {
      table.head = std::move(cells);
    } else {
      table.rows.push_back(std::move(cells));
    }
  }
  const std::size_t status = table.column("status");
  for (const io::Cells& row : table.rows)
    if (row[status] != "ok") throw std::invalid_argument(row[0] + " is not ok");
  return table;
}

// The columns that a sum adds up.
std::vector<std::size_t> columns_of(const Table& table, std::string sum) {
  std::vector<std::size_t> columns;
  if (sum.ends_with('*')) {
    sum.pop_back();
    for (std::size_t i = 0; i < table.head.size(); ++i)
      if (table.head[i].starts_with(sum)) columns.push_back(i);
    return columns;
  }
  for (std::size_t begin = 0; begin <= sum.size();) {
    const std::size_t end = std::min(sum.find('+', begin), sum.size());
    columns.push_back(table.column(sum.substr(begin, end - begin)));
    begin = end + 1;
  }
  return columns;
}

double sum_in(const io::Cells& row, const std::vector<std::size_t>& columns) {
  double sum = 0;
  for (const std::size_t column : columns) sum += io::number_in(row[column]).value();
  return sum;
}

// The values of one sum for one value of the factor: one mean over the games of each pair.
struct Sums {
  std::map<int, std::vector<double>> by_pair;

  experiments::DifferenceByPair means() const {
    experiments::DifferenceByPair means;
    for (const auto& [pair, sums] : by_pair) means[pair] = experiments::mean(sums);
    return means;
  }
  double mean_of_all() const {
    std::vector<double> all;
    for (const auto& [pair, sums] : by_pair) all.insert(all.end(), sums.begin(), sums.end());
    return experiments::mean(all);
  }
};

struct Line {
  std::string combination;  // values of the other factors
  std::string sum;
  std::string first;  // value of the factor with which the other is compared
  std::string value;
  double before = 0;
  double after = 0;
  experiments::PairedDifference change;
};

class Comparison {
 public:
  Comparison(const Table& table, const std::string& factor)
      : table_(table), factor_(table.column(factor)) {
    // The factors are between the columns leg and team_a.
    for (std::size_t i = table.column("leg") + 1; i < table.column("team_a"); ++i)
      if (i != factor_) others_.push_back(i);
  }

  void add(const std::string& sum) {
    const std::vector<std::size_t> columns = columns_of(table_, sum);
    const std::size_t pair = table_.column("pair");
    std::vector<std::string> combinations, values;
    std::map<std::pair<std::string, std::string>, Sums> cells;
    for (const io::Cells& row : table_.rows) {
      const std::string combination = combination_of(row);
      note(combinations, combination);
      note(values, row[factor_]);
      cells[{combination, row[factor_]}].by_pair[std::stoi(row[pair])].push_back(
          sum_in(row, columns));
    }
    for (const std::string& combination : combinations) {
      const Sums& first = cells[{combination, values.front()}];
      for (std::size_t i = 1; i < values.size(); ++i) {
        const Sums& other = cells[{combination, values[i]}];
        lines_.push_back({combination, sum, values[0], values[i], first.mean_of_all(),
                          other.mean_of_all(),
                          experiments::paired_difference(other.means(), first.means())});
      }
    }
  }

  void print() {
    correct();
    fmt::print("| games | of each | {} | change to | pairs | change [95 %] | p |\n",
               table_.head[factor_]);
    fmt::print("|---|---|--:|--:|--:|--:|--:|\n");
    for (const Line& line : lines_) {
      const std::string interval =
          line.change.interval ? fmt::format("[{:+.2f}, {:+.2f}]", line.change.interval->low,
                                             line.change.interval->high)
                               : "";
      fmt::print("| {} | {} | {}: {:.2f} | {}: {:.2f} | {} | {:+.2f} {} | {} |\n", line.combination,
                 line.sum, line.first, line.before, line.value, line.after, line.change.pairs,
                 line.change.mean.value_or(0), interval, p_text(line.change.p_holm));
    }
  }

 private:
  static void note(std::vector<std::string>& seen, const std::string& value) {
    if (std::find(seen.begin(), seen.end(), value) == seen.end()) seen.push_back(value);
  }

  static std::string p_text(const std::optional<double>& p) {
    if (!p) return "";
    return *p < 0.001 ? "<0.001" : fmt::format("{:.3f}", *p);
  }

  std::string combination_of(const io::Cells& row) const {
    std::string text;
    for (const std::size_t other : others_)
      text += fmt::format("{}{}={}", text.empty() ? "" : ", ", table_.head[other], row[other]);
    return text;
  }

  void correct() {
    std::vector<double> p;
    for (const Line& line : lines_)
      if (line.change.p) p.push_back(*line.change.p);
    const std::vector<double> corrected = experiments::holm(p);
    auto next = corrected.begin();
    for (Line& line : lines_)
      if (line.change.p) line.change.p_holm = *next++;
  }

  const Table& table_;
  std::size_t factor_;
  std::vector<std::size_t> others_;
  std::vector<Line> lines_;
};

}  // namespace
}  // namespace autoref::tools

int main(int count, char** words) {
  using namespace autoref::tools;
  if (count < 4) {
    fmt::print(stderr, "usage: column_effects RESULTS.CSV FACTOR SUM ...\n");
    return 2;
  }
  try {
    const Table table = read_table(words[1]);
    Comparison comparison(table, words[2]);
    for (int i = 3; i < count; ++i) comparison.add(words[i]);
    comparison.print();
  } catch (const std::exception& error) {
    fmt::print(stderr, "column_effects: {}: {}\n", words[1], error.what());
    return 2;
  }
}
