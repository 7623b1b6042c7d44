#include "experiments/analysis/standings.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

int sum_of(const std::vector<double>& goals) {
  return static_cast<int>(std::accumulate(goals.begin(), goals.end(), 0.0));
}

// `sign` is -1 if the team is b in the matchup.
void add_differences(Standing& standing, const Group& matchup, double sign) {
  for (const double difference : matchup.differences) {
    standing.differences.push_back(sign * difference);
  }
  for (const double difference : values_of(matchup.pair_differences)) {
    standing.pair_differences.push_back(sign * difference);
  }
  standing.draws += matchup.draws;
  standing.void_games += matchup.void_games;
}

void add_a(Standing& standing, const Group& matchup) {
  standing.wins += matchup.wins_a;
  standing.losses += matchup.wins_b;
  standing.goals_for += sum_of(matchup.goals_a);
  standing.goals_against += sum_of(matchup.goals_b);
  add_differences(standing, matchup, 1);
}

void add_b(Standing& standing, const Group& matchup) {
  standing.wins += matchup.wins_b;
  standing.losses += matchup.wins_a;
  standing.goals_for += sum_of(matchup.goals_b);
  standing.goals_against += sum_of(matchup.goals_a);
  add_differences(standing, matchup, -1);
}

std::vector<RatedMatchup> rated(const std::vector<Group>& matchups) {
  std::vector<RatedMatchup> all;
  all.reserve(matchups.size());
  for (const Group& matchup : matchups)
    all.push_back({matchup.values[0], matchup.values[1], matchup.games_by_pair});
  return all;
}

void rate(const std::vector<Group>& matchups, std::map<std::string, Standing>& by_team) {
  const std::vector<RatedMatchup> all = rated(matchups);
  for (const Rating& rating : goal_ratings_of(all)) by_team[rating.team].goals = rating;
  for (const Rating& rating : bradley_terry_ratings_of(all)) by_team[rating.team].strength = rating;
  for (auto& [team, standing] : by_team) standing.is_rated = true;
}

double mean_difference(const Standing& standing) {
  return standing.differences.empty() ? 0 : mean(standing.differences);
}

bool is_better(const Standing& left, const Standing& right) {
  const double of_left = mean_difference(left);
  const double of_right = mean_difference(right);
  // Lexicographic; names break ties, so the order is always the same.
  return std::tuple(-left.points(), -of_left, left.team) <
         std::tuple(-right.points(), -of_right, right.team);
}

std::vector<Standing> ordered(const std::map<std::string, Standing>& by_team) {
  std::vector<Standing> standings;
  standings.reserve(by_team.size());
  for (const auto& [team, standing] : by_team) {
    standings.push_back(standing);
    standings.back().team = team;
  }
  std::sort(standings.begin(), standings.end(), is_better);
  int rank = 0;
  for (Standing& standing : standings) standing.rank = ++rank;
  return standings;
}

}  // namespace

std::vector<Group> grouped(const std::vector<Matchup>& matchups, const RowsById& rows) {
  std::vector<io::Cells> values;
  values.reserve(matchups.size());
  for (const Matchup& matchup : matchups) values.push_back({matchup.team_a, matchup.team_b});
  const auto teams_of = [](const GameRow& row) { return io::Cells{row.team_a, row.team_b}; };
  return grouped(values, teams_of, rows);
}

std::vector<Standing> standings_of(const std::vector<Group>& matchups) {
  std::map<std::string, Standing> by_team;
  for (const Group& matchup : matchups) {
    add_a(by_team[matchup.values[0]], matchup);
    add_b(by_team[matchup.values[1]], matchup);
  }
  rate(matchups, by_team);
  return ordered(by_team);
}

std::vector<Standing> standings_of_challengers(const std::vector<Group>& matchups) {
  std::map<std::string, Standing> by_team;
  for (const Group& matchup : matchups) add_a(by_team[matchup.values[0]], matchup);
  return ordered(by_team);
}

bool are_rated(const std::vector<Standing>& standings) {
  return !standings.empty() && standings.front().is_rated;
}

}  // namespace autoref::experiments
