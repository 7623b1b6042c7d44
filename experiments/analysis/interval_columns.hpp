// Columns for the bounds of a 95 % confidence interval.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "experiments/statistics/interval.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {

// The interval's bounds; both nullopt without an interval.
inline std::pair<std::optional<double>, std::optional<double>> bounds_of(
    const std::optional<Interval>& interval) {
  if (!interval) return {};
  return {interval->low, interval->high};
}

// The columns low95 and high95, with a prefix such as "diff_".
template <typename Row>
io::TableColumns<Row> interval_columns(
    const std::string& prefix, const std::function<std::optional<Interval>(const Row&)>& interval) {
  return {
      {prefix + "low95", [interval](const Row& row) { return bounds_of(interval(row)).first; }},
      {prefix + "high95", [interval](const Row& row) { return bounds_of(interval(row)).second; }}};
}

}  // namespace autoref::experiments
