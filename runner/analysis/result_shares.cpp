#include "runner/analysis/result_shares.hpp"

#include <fmt/format.h>

#include <numeric>

#include "runner/analysis/groups.hpp"
#include "runner/statistics/proportion_interval.hpp"

namespace autoref::runner {
namespace {

Cells share_of(int part, int whole) {
  const auto& [low, high] = bounds_of(proportion_interval(part, whole));
  return {whole == 0 ? "" : number_cell(static_cast<double>(part) / whole), number_cell(low),
          number_cell(high)};
}

}  // namespace

Cells share_columns(const std::array<std::string, 3>& names) {
  Cells columns(names.begin(), names.end());
  for (const std::string& name : names) {
    append(columns, {name + "_share", name + "_low95", name + "_high95"});
  }
  return columns;
}

Cells share_cells(const ResultCounts& counts) {
  const int games = std::accumulate(counts.begin(), counts.end(), 0);
  Cells cells;
  for (const int count : counts) cells.push_back(std::to_string(count));
  for (const int count : counts) append(cells, share_of(count, games));
  return cells;
}

std::string share_text(int part, int whole) {
  const std::optional<Interval> interval = proportion_interval(part, whole);
  if (!interval) return "-";
  return fmt::format("{:.0f} % [{:.0f}, {:.0f}]", 100.0 * part / whole, 100 * interval->low,
                     100 * interval->high);
}

}  // namespace autoref::runner
