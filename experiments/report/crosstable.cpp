#include "experiments/report/crosstable.hpp"

#include <algorithm>

#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

CrossCell cell_of_a(const Group& group) {
  CrossCell cell{group.wins_a, group.draws, group.wins_b, {}};
  if (!group.differences.empty()) cell.mean_difference = mean(group.differences);
  return cell;
}

CrossCell from_other_side(const CrossCell& cell) {
  CrossCell other{cell.losses, cell.draws, cell.wins, {}};
  // Avoid -0, which would be printed with a minus sign.
  if (cell.mean_difference) other.mean_difference = 0 - *cell.mean_difference;
  return other;
}

std::optional<std::size_t> rank_of(const Crosstable& table, const std::string& team) {
  const auto found = std::find(table.teams.begin(), table.teams.end(), team);
  if (found == table.teams.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.teams.begin());
}

}  // namespace

std::optional<Crosstable> crosstable_of(const ExperimentResults& results) {
  Crosstable table;
  for (const Standing& standing : results.standings) table.teams.push_back(standing.team);
  if (table.teams.size() < 2) return std::nullopt;
  table.cells.assign(table.teams.size(), std::vector<std::optional<CrossCell>>(table.teams.size()));
  for (const Group& group : results.groups) {
    if (group.values.size() != 2) return std::nullopt;
    const std::optional<std::size_t> a = rank_of(table, group.values[0]);
    const std::optional<std::size_t> b = rank_of(table, group.values[1]);
    if (!a || !b || *a == *b) return std::nullopt;
    table.cells[*a][*b] = cell_of_a(group);
    table.cells[*b][*a] = from_other_side(*table.cells[*a][*b]);
  }
  return table;
}

}  // namespace autoref::experiments
