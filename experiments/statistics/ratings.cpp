#include "experiments/statistics/ratings.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

#include "experiments/statistics/penalised_likelihood.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

using Eigen::VectorXd;

constexpr int kMostProfileSteps = 100;
constexpr double kTolerance = 1e-6;  // tolerance of the log-likelihood
constexpr double kOpenEnd = std::numeric_limits<double>::infinity();

enum class ProfileEnd { kLow, kHigh };

// The profile likelihood of one team's strength.
struct StrengthProfile {
  std::size_t team = 0;
  VectorXd direction;  // the team against its group's mean
  double value = 0;    // log-likelihood at both ends of the interval
};

// Quantities of Venzon and Moolgavkar's quadratic model at a point.
struct ProfileStep {
  VectorXd change;
  double short_of_maximum = 0;  // the other teams' distance from the maximum
};

// The likelihood is modelled as value + score' d - d' curvature d / 2. The model is largest for the
// other teams along d = newton + slope * across, with any slope; choose the slope for which the
// model has the profile's value, on the side of the wanted end. If the model does not reach that
// value anywhere, go to its maximum.
ProfileStep step_from(const LikelihoodPoint& point, const StrengthProfile& profile,
                      ProfileEnd end) {
  const VectorXd newton = point.curvature.solve(point.score);
  const VectorXd across = point.curvature.solve(profile.direction);
  const double gain = point.score.dot(newton);
  const double spread = profile.direction.dot(across);
  const double along = point.score.dot(across);
  const double squared = 2 * (point.value - profile.value + gain / 2) / spread;
  const double slope = std::sqrt(std::max(squared, 0.0));
  return {newton + (end == ProfileEnd::kHigh ? slope : -slope) * across,
          (gain - along * along / spread) / 2};
}

// The strength at one end of the interval; nullopt if that end is not found.
std::optional<double> profile_end(const PenalisedLikelihood& likelihood, LikelihoodPoint point,
                                  const StrengthProfile& profile, ProfileEnd end) {
  for (int i = 0; i < kMostProfileSteps && std::isfinite(point.value); ++i) {
    const ProfileStep step = step_from(point, profile, end);
    if (std::abs(point.value - profile.value) < kTolerance && step.short_of_maximum < kTolerance) {
      return point.strengths(profile.team);
    }
    point = likelihood.at(point.strengths + shortened_step(step.change));
  }
  return std::nullopt;
}

// The numbers of games and wins of a team.
struct GamesAndWins {
  double games = 0;
  double wins = 0;
};

std::vector<GamesAndWins> games_and_wins(const PenalisedLikelihood& likelihood) {
  std::vector<GamesAndWins> results(likelihood.groups().size());
  for (const MatchupTotals& matchup : likelihood.matchups()) {
    results[matchup.a].games += matchup.games;
    results[matchup.a].wins += matchup.wins;
    results[matchup.b].games += matchup.games;
    results[matchup.b].wins += matchup.games - matchup.wins;
  }
  return results;
}

constexpr std::uint64_t kStreamKey = 1979;
constexpr double kDrawnWin = 0.5;  // the value of a draw as a win

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
  std::vector<std::string> teams;  // names by team number, sorted
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
  // Drawing with replacement: any pair can stand in for the i-th.
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

double dispersion(const PenalisedLikelihood& likelihood, const LikelihoodPoint& maximum) {
  double draws = 0;
  for (const MatchupTotals& matchup : likelihood.matchups()) draws += matchup.draws;
  if (!(draws > 0)) return 1;
  return std::clamp(1 - draws / 4 / maximum.win_variance, kLeastDispersion, 1.0);
}

std::vector<std::optional<Interval>> profile_intervals(const PenalisedLikelihood& likelihood,
                                                       const LikelihoodPoint& maximum) {
  const double quantile =
      boost::math::quantile(complement(boost::math::chi_squared(1), kMissedShare));
  const double value = maximum.value - dispersion(likelihood, maximum) * quantile / 2;
  const std::vector<GamesAndWins> results = games_and_wins(likelihood);
  std::vector<std::optional<Interval>> intervals(results.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!(results[i].games > 0)) continue;
    const StrengthProfile profile{i, likelihood.direction_of(i), value};
    const std::optional<double> low =
        results[i].wins > 0 ? profile_end(likelihood, maximum, profile, ProfileEnd::kLow)
                            : -kOpenEnd;
    const std::optional<double> high =
        results[i].wins < results[i].games
            ? profile_end(likelihood, maximum, profile, ProfileEnd::kHigh)
            : kOpenEnd;
    if (low && high) intervals[i] = Interval{*low, *high};
  }
  return intervals;
}

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
