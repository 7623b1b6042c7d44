#include "experiments/statistics/ratings.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "experiments/statistics/goal_rating.hpp"
#include "experiments/statistics/penalised_likelihood.hpp"
#include "experiments/statistics/strength_profile.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

constexpr std::uint64_t kStreamKey = 1979;
constexpr double kDrawnWin = 0.5;  // the win of a drawn game

// Sums of each pair of a matchup, with numbered teams.
using PairTotals = std::vector<MatchupTotals>;

std::vector<std::string> teams_of(const std::vector<RatedMatchup>& matchups) {
  std::vector<std::string> teams;
  for (const RatedMatchup& matchup : matchups) {
    teams.push_back(matchup.team_a);
    teams.push_back(matchup.team_b);
  }
  std::sort(teams.begin(), teams.end());
  teams.erase(std::unique(teams.begin(), teams.end()), teams.end());
  return teams;
}

std::size_t number_of(const std::string& team, const std::vector<std::string>& teams) {
  return std::lower_bound(teams.begin(), teams.end(), team) - teams.begin();
}

PairTotals pair_totals(const RatedMatchup& matchup, const std::vector<std::string>& teams) {
  PairTotals totals;
  for (const auto& [pair, games] : matchup.pairs) {
    MatchupTotals sum{number_of(matchup.team_a, teams), number_of(matchup.team_b, teams)};
    sum.games = static_cast<double>(games.size());
    for (const RatedGame& game : games) {
      sum.difference += game.difference;
      sum.wins += game.win;
      sum.draws += game.win == kDrawnWin ? 1 : 0;
    }
    totals.push_back(sum);
  }
  return totals;
}

void add(MatchupTotals& sum, const MatchupTotals& pair) {
  sum.games += pair.games;
  sum.difference += pair.difference;
  sum.wins += pair.wins;
  sum.draws += pair.draws;
}

// Sums up each matchup over n of its pairs; `pick` chooses the i-th of them.
template <typename Pick>
std::vector<MatchupTotals> totals_of(const std::vector<PairTotals>& matchups, Pick pick) {
  std::vector<MatchupTotals> totals;
  for (const PairTotals& pairs : matchups) {
    MatchupTotals sum{pairs.front().a, pairs.front().b};
    for (std::size_t i = 0; i < pairs.size(); ++i) add(sum, pairs[pick(i, pairs.size())]);
    totals.push_back(sum);
  }
  return totals;
}

// All matchups with games, with numbered teams.
struct NumberedGames {
  std::vector<std::string> teams;  // by number, sorted
  std::vector<PairTotals> matchups;
};

NumberedGames numbered_games(std::vector<RatedMatchup>& matchups) {
  std::sort(matchups.begin(), matchups.end(), [](const RatedMatchup& x, const RatedMatchup& y) {
    return std::tie(x.team_a, x.team_b) < std::tie(y.team_a, y.team_b);
  });
  NumberedGames games{teams_of(matchups), {}};
  for (const RatedMatchup& matchup : matchups) {
    if (!matchup.pairs.empty()) games.matchups.push_back(pair_totals(matchup, games.teams));
  }
  return games;
}

std::vector<MatchupTotals> totals_of(const NumberedGames& games) {
  return totals_of(games.matchups, [](std::size_t i, std::size_t) { return i; });
}

std::vector<Rating> without_intervals(const NumberedGames& games, const Eigen::VectorXd& values) {
  std::vector<Rating> ratings;
  for (std::size_t i = 0; i < games.teams.size(); ++i) {
    ratings.push_back({games.teams[i], values(i), {}});
  }
  return ratings;
}

// One column per resample, one row per team.
Eigen::MatrixXd resampled(std::size_t teams, const std::vector<PairTotals>& matchups) {
  Eigen::MatrixXd outcomes(teams, kResamples);
  RandomStream random(kStreamKey);
  // Drawing with replacement: any pair may stand in for the i-th.
  const auto any = [&random](std::size_t, std::size_t n) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
  };
  for (int i = 0; i < kResamples; ++i)
    outcomes.col(i) = goal_rating(teams, totals_of(matchups, any));
  return outcomes;
}

void add_intervals(std::vector<Rating>& ratings, const std::vector<PairTotals>& matchups) {
  const Eigen::MatrixXd outcomes = resampled(ratings.size(), matchups);
  for (std::size_t i = 0; i < ratings.size(); ++i) {
    const Eigen::VectorXd row = outcomes.row(i);
    const std::vector<double> sample(row.begin(), row.end());
    const Interval middle{quantile_of(sample, kMissedShare / 2),
                          quantile_of(sample, 1 - kMissedShare / 2)};
    if (middle.low < middle.high) ratings[i].interval = middle;
  }
}

}  // namespace

std::vector<Rating> goal_ratings_of(std::vector<RatedMatchup> matchups) {
  const NumberedGames games = numbered_games(matchups);
  std::vector<Rating> ratings =
      without_intervals(games, goal_rating(games.teams.size(), totals_of(games)));
  const bool can_be_resampled =
      !games.matchups.empty() &&
      std::all_of(games.matchups.begin(), games.matchups.end(),
                  [](const PairTotals& pairs) { return pairs.size() >= kFewestResampled; });
  if (can_be_resampled) add_intervals(ratings, games.matchups);
  return ratings;
}

std::vector<Rating> bradley_terry_ratings_of(std::vector<RatedMatchup> matchups) {
  const NumberedGames games = numbered_games(matchups);
  const PenalisedLikelihood likelihood(games.teams.size(), totals_of(games));
  const LikelihoodPoint maximum = likelihood.maximum();
  std::vector<Rating> ratings = without_intervals(games, maximum.strengths);
  const std::vector<std::optional<Interval>> intervals = profile_intervals(likelihood, maximum);
  for (std::size_t i = 0; i < ratings.size(); ++i) ratings[i].interval = intervals[i];
  return ratings;
}

double quantile_of(std::vector<double> sample, double share) {
  assert(!sample.empty() && 0 <= share && share <= 1);
  std::sort(sample.begin(), sample.end());
  const double rank = share * static_cast<double>(sample.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sample.size() - 1);
  return std::lerp(sample[below], sample[above], rank - static_cast<double>(below));
}

}  // namespace autoref::experiments
