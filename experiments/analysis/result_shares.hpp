// Fractions of games won, drawn and lost, with confidence intervals.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "experiments/analysis/interval_columns.hpp"
#include "experiments/statistics/proportion_interval.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {

// Numbers of games won, drawn and lost.
using ResultCounts = std::array<int, 3>;

// A number of games, and the number of all games.
struct ResultShare {
  int part = 0;
  int whole = 0;

  std::optional<double> fraction() const {
    return whole == 0 ? std::nullopt : std::optional(static_cast<double>(part) / whole);
  }
  std::optional<Interval> interval() const { return proportion_interval(part, whole); }
};

// The columns for the shares of some columns of whole numbers in their sum: for each of them its
// fraction and that fraction's 95 % interval, such as "wins_a_share", "wins_a_low95" and
// "wins_a_high95". The intervals are those of proportion_interval(), which assumes independent
// games. Without games, these cells are empty.
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

}  // namespace autoref::experiments
