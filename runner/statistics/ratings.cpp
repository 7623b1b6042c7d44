#include "runner/statistics/ratings.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "soccer/random.hpp"

namespace autoref::runner {
namespace {

constexpr std::uint64_t kStreamKey = 1979;

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
    }
    totals.push_back(sum);
  }
  return totals;
}

void add(MatchupTotals& sum, const MatchupTotals& pair) {
  sum.games += pair.games;
  sum.difference += pair.difference;
  sum.wins += pair.wins;
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

std::vector<PairTotals> played(std::vector<RatedMatchup>& matchups,
                               const std::vector<std::string>& teams) {
  std::sort(matchups.begin(), matchups.end(), [](const RatedMatchup& x, const RatedMatchup& y) {
    return std::tie(x.team_a, x.team_b) < std::tie(y.team_a, y.team_b);
  });
  std::vector<PairTotals> played;
  for (const RatedMatchup& matchup : matchups) {
    if (!matchup.pairs.empty()) played.push_back(pair_totals(matchup, teams));
  }
  return played;
}

// One column per resample, one row per team.
Eigen::MatrixXd resampled(std::size_t teams, const std::vector<PairTotals>& matchups,
                          const RatingMethod& rate) {
  Eigen::MatrixXd outcomes(teams, kResamples);
  RandomStream random(kStreamKey);
  // Drawing with replacement: any pair may stand in for the i-th.
  const auto any = [&random](std::size_t, std::size_t n) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
  };
  for (int i = 0; i < kResamples; ++i) outcomes.col(i) = rate(teams, totals_of(matchups, any));
  return outcomes;
}

void add_intervals(std::vector<Rating>& ratings, const std::vector<PairTotals>& matchups,
                   const RatingMethod& rate) {
  const Eigen::MatrixXd outcomes = resampled(ratings.size(), matchups, rate);
  for (std::size_t i = 0; i < ratings.size(); ++i) {
    const Eigen::VectorXd row = outcomes.row(i);
    const std::vector<double> sample(row.begin(), row.end());
    const Interval middle{quantile_of(sample, kMissedShare / 2),
                          quantile_of(sample, 1 - kMissedShare / 2)};
    if (middle.low < middle.high) ratings[i].interval = middle;
  }
}

}  // namespace

std::vector<Rating> ratings_of(std::vector<RatedMatchup> matchups, const RatingMethod& rate) {
  const std::vector<std::string> teams = teams_of(matchups);
  const std::vector<PairTotals> games = played(matchups, teams);
  const Eigen::VectorXd values =
      rate(teams.size(), totals_of(games, [](std::size_t i, std::size_t) { return i; }));
  std::vector<Rating> ratings;
  for (std::size_t i = 0; i < teams.size(); ++i) ratings.push_back({teams[i], values(i), {}});
  const bool can_be_resampled =
      !games.empty() && std::all_of(games.begin(), games.end(), [](const PairTotals& pairs) {
        return pairs.size() >= kFewestResampled;
      });
  if (can_be_resampled) add_intervals(ratings, games, rate);
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

}  // namespace autoref::runner
