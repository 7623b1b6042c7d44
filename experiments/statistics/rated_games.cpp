#include "experiments/statistics/rated_games.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace autoref::experiments {
namespace {

// The first team of the tree that contains `team`. Shortens the path to it by half.
std::size_t root_of(std::vector<std::size_t>& parents, std::size_t team) {
  while (parents[team] != team) {
    parents[team] = parents[parents[team]];
    team = parents[team];
  }
  return team;
}

}  // namespace

std::vector<std::size_t> linked_groups(std::size_t teams, std::span<const MatchupTotals> totals) {
  std::vector<std::size_t> parents(teams);
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  for (const MatchupTotals& matchup : totals) {
    if (!(matchup.games > 0)) continue;
    const std::size_t of_a = root_of(parents, matchup.a);
    const std::size_t of_b = root_of(parents, matchup.b);
    parents[std::max(of_a, of_b)] = std::min(of_a, of_b);
  }
  std::map<std::size_t, std::size_t> numbers;  // number of each group, by the group's root
  std::vector<std::size_t> groups(teams);
  for (std::size_t i = 0; i < teams; ++i) {
    groups[i] = numbers.try_emplace(root_of(parents, i), numbers.size()).first->second;
  }
  return groups;
}

Eigen::MatrixXd group_means(const std::vector<std::size_t>& groups) {
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(groups.size(), groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto members = std::count(groups.begin(), groups.end(), groups[i]);
    for (std::size_t j = 0; j < groups.size(); ++j) {
      if (groups[i] == groups[j]) means(i, j) = 1 / static_cast<double>(members);
    }
  }
  return means;
}

void add_to_normal_equations(Eigen::MatrixXd& equations, const MatchupTotals& matchup,
                             double weight) {
  equations(matchup.a, matchup.a) += weight;
  equations(matchup.b, matchup.b) += weight;
  equations(matchup.a, matchup.b) -= weight;
  equations(matchup.b, matchup.a) -= weight;
}

}  // namespace autoref::experiments
