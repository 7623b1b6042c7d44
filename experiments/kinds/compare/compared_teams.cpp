#include "experiments/kinds/compare/compared_teams.hpp"

#include <algorithm>
#include <utility>

#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {
namespace {

bool has_all_rows(const std::vector<std::string>& matchups, int pair, const RowsById& rows) {
  for (const std::string& matchup : matchups) {
    for (const int leg : {1, 2})
      if (!rows.contains(game_id(matchup, pair, leg))) return false;
  }
  return true;
}

// The difference against one opponent, for pair numbers that both groups have.
DifferenceByPair minus(const DifferenceByPair& of_new, const DifferenceByPair& of_old) {
  DifferenceByPair differences;
  for (const auto& [pair, lead] : of_new) {
    const auto other = of_old.find(pair);
    if (other != of_old.end()) differences[pair] = lead - other->second;
  }
  return differences;
}

// Counts games of both groups with the same state hash.
int equal_games(const std::string& opponent, const RowsById& rows) {
  const std::string of_new = matchup_name({kNewTeam, opponent}) + "-";
  const std::string of_old = matchup_name({kOldTeam, opponent}) + "-";
  int count = 0;
  for (auto row = rows.lower_bound(of_new); row != rows.end() && row->first.starts_with(of_new);
       ++row) {
    const auto other = rows.find(of_old + row->first.substr(of_new.size()));
    if (other == rows.end() || is_void(row->second.record)) continue;
    count += row->second.record.state_hash == other->second.record.state_hash ? 1 : 0;
  }
  return count;
}

// In the order of matchups_of().
std::vector<ComparedOpponent> opponents_in(const Comparison& comparison, const RowsById& rows) {
  std::vector<Group> groups = grouped(matchups_of(comparison), rows);
  std::vector<ComparedOpponent> opponents;
  opponents.push_back(
      {kOldTeam, groups[0], std::nullopt, DifferenceByPair(groups[0].pair_differences)});
  for (std::size_t i = 1; i + 1 < groups.size(); i += 2) {
    DifferenceByPair differences =
        minus(groups[i].pair_differences, groups[i + 1].pair_differences);
    std::string name = groups[i].values[1];
    const int equal = equal_games(name, rows);
    opponents.push_back({std::move(name), std::move(groups[i]), std::move(groups[i + 1]),
                         std::move(differences), equal});
  }
  return opponents;
}

// The rows of these pair numbers.
RowsById rows_with(const std::vector<int>& pairs, const RowsById& rows) {
  RowsById some;
  for (const auto& [id, row] : rows)
    if (std::binary_search(pairs.begin(), pairs.end(), row.pair)) some[id] = row;
  return some;
}

// The mean difference over all opponents; nullopt if a leg is void.
std::optional<double> mean_difference(const std::vector<ComparedOpponent>& opponents, int pair) {
  double sum = 0;
  for (const ComparedOpponent& opponent : opponents) {
    const auto difference = opponent.differences.find(pair);
    if (difference == opponent.differences.end()) return std::nullopt;
    sum += difference->second;
  }
  return sum / static_cast<double>(opponents.size());
}

}  // namespace

ComparedTeams compared_teams(const Comparison& comparison, const RowsById& rows) {
  ComparedTeams compared;
  compared.opponents = opponents_in(comparison, rows);
  std::vector<std::string> matchups;
  for (const Matchup& matchup : matchups_of(comparison)) matchups.push_back(matchup_name(matchup));
  std::vector<double> differences;
  std::vector<int> numbers;  // the pair numbers of the differences
  int last = 0;
  const auto is_at_end = [&] {
    return last == comparison.test.max_pairs || (numbers.empty() && last == kMostVoidPairsAtFirst);
  };
  while (!is_at_end() && has_all_rows(matchups, last + 1, rows)) {
    const std::optional<double> difference = mean_difference(compared.opponents, ++last);
    if (!difference) continue;
    differences.push_back(*difference);
    numbers.push_back(last);
  }
  compared.test = decided_by(comparison.test, differences);
  compared.last_pair = last;
  if (compared.test.verdict != ThreeWayVerdict::kGoOn) {
    compared.last_pair = numbers[static_cast<std::size_t>(compared.test.pairs - 1)];
  } else if (is_at_end()) {  // void legs left fewer than max_pairs
    compared.test.verdict = ThreeWayVerdict::kUndecided;
  }
  numbers.resize(static_cast<std::size_t>(compared.test.pairs));
  compared.pairs = std::move(numbers);
  compared.is_decided = compared.test.verdict != ThreeWayVerdict::kGoOn;
  compared.void_pairs = compared.last_pair - compared.test.pairs;
  return compared;
}

std::vector<ComparedOpponent> considered_opponents(const Comparison& comparison,
                                                   const ComparedTeams& compared,
                                                   const RowsById& rows) {
  return opponents_in(comparison, rows_with(compared.pairs, rows));
}

}  // namespace autoref::experiments
