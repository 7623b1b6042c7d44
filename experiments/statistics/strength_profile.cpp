#include "experiments/statistics/strength_profile.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>

namespace autoref::experiments {
namespace {

using Eigen::VectorXd;

constexpr int kMostProfileSteps = 100;
constexpr double kTolerance = 1e-6;  // of the likelihood's logarithm
constexpr double kOpenEnd = std::numeric_limits<double>::infinity();

enum class ProfileEnd { kLow, kHigh };

// The profile of one team.
struct StrengthProfile {
  std::size_t team = 0;
  VectorXd direction;  // the team against its group's mean
  double value = 0;    // of the likelihood's logarithm at both ends
};

// Quantities of Venzon and Moolgavkar's quadratic model at a point.
struct ProfileStep {
  VectorXd change;
  double short_of_maximum = 0;  // how far the other teams are from as likely as possible
};

// The likelihood is modelled as value + score' d - d' curvature d / 2. The model is largest for the
// other teams along d = newton + slope * across, with any slope; choose the slope for which it has
// the profile's value, on the side of the wanted end. If it has that value nowhere, go to its
// maximum.
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

// The strength at an end of the interval; nullopt if it is not found.
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

// Games and wins of a team.
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

}  // namespace autoref::experiments
