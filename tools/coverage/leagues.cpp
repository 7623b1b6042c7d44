#include "tools/coverage/leagues.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/poisson.hpp>
#include <cmath>

#include "experiments/statistics/penalised_likelihood.hpp"
#include "tools/coverage/goals.hpp"

namespace autoref::coverage {
namespace {

constexpr double kGoalsOfEquals = 2;  // expected goals of each of two equal teams
constexpr int kMostGoals = 200;
constexpr double kVeryManyGames = 1e12;

experiments::RatedGame rated(const Score& score) {
  const int difference = score.difference();
  return {static_cast<double>(difference), difference > 0 ? 1.0 : difference < 0 ? 0.0 : 0.5};
}

Means means_of(double skill_a, double skill_b) {
  return {kGoalsOfEquals * std::exp(skill_a - skill_b),
          kGoalsOfEquals * std::exp(skill_b - skill_a)};
}

// The expected number of wins of team a in one game, where a draw counts as half a win.
double expected_wins(const Means& means) {
  const boost::math::poisson of_a(means.a);
  const boost::math::poisson of_b(means.b);
  double wins = 0;
  for (int goals = 0; goals <= kMostGoals; ++goals) {
    wins += pdf(of_a, goals) * ((goals > 0 ? cdf(of_b, goals - 1) : 0) + pdf(of_b, goals) / 2);
  }
  return wins;
}

std::vector<experiments::MatchupTotals> expected_totals(const std::vector<double>& skills) {
  std::vector<experiments::MatchupTotals> totals;
  for (std::size_t i = 0; i < skills.size(); ++i) {
    for (std::size_t j = i + 1; j < skills.size(); ++j) {
      const Means means = means_of(skills[i], skills[j]);
      totals.push_back({.a = i,
                        .b = j,
                        .games = kVeryManyGames,
                        .difference = kVeryManyGames * (means.a - means.b),
                        .wins = kVeryManyGames * expected_wins(means)});
    }
  }
  return totals;
}

std::vector<double> list_of(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

// The names sort in the same order as the teams' numbers.
std::string team_name(std::size_t number) { return fmt::format("{:03}", number); }

}  // namespace

League model_league(const std::string& name, const std::vector<double>& strengths, double draws) {
  const PlayGame play = [=](std::size_t i, std::size_t j, RandomStream& random) {
    const double chance = 1 / (1 + std::exp(strengths[j] - strengths[i]));
    const double half_a_draw = draws * chance * (1 - chance);
    const double drawn = random.uniform() - (chance - half_a_draw);
    if (drawn < 0) return experiments::RatedGame{1, 1};
    return drawn < 2 * half_a_draw ? experiments::RatedGame{0, 0.5} : experiments::RatedGame{-1, 0};
  };
  return {name, play, {}, strengths};
}

League poisson_league(const std::string& name, const std::vector<double>& skills) {
  const PlayGame play_game = [=](std::size_t i, std::size_t j, RandomStream& random) {
    return rated(play(means_of(skills[i], skills[j]), random));
  };
  const std::vector<experiments::MatchupTotals> totals = expected_totals(skills);
  return {name, play_game, list_of(experiments::goal_rating(skills.size(), totals)),
          list_of(experiments::bradley_terry(skills.size(), totals))};
}

std::vector<experiments::RatedMatchup> play_round_robin(const League& league, int pairs,
                                                        RandomStream& random) {
  std::vector<experiments::RatedMatchup> matchups;
  for (std::size_t i = 0; i < league.strengths.size(); ++i) {
    for (std::size_t j = i + 1; j < league.strengths.size(); ++j) {
      experiments::RatedMatchup matchup{team_name(i), team_name(j), {}};
      for (int pair = 1; pair <= pairs; ++pair) {
        matchup.pairs[pair] = {league.play(i, j, random), league.play(i, j, random)};
      }
      matchups.push_back(std::move(matchup));
    }
  }
  return matchups;
}

}  // namespace autoref::coverage
