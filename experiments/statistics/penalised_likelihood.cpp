#include "experiments/statistics/penalised_likelihood.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "experiments/statistics/rated_games.hpp"

namespace autoref::experiments {
namespace {

constexpr int kMostNewtonSteps = 200;
constexpr int kMostHalvings = 30;
constexpr double kSmallStep = 1e-10;
constexpr double kLongestStep = 2;
// Relative rounding error that could be mistaken for a falling likelihood.
constexpr double kRelativeRounding = 1e-13;

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The model's prediction for one game of a matchup.
struct PredictedGame {
  double win = 0;       // probability that a wins
  double variance = 0;  // win (1 - win)
  double log_win = 0;
  double log_loss = 0;
};

// The prediction remains accurate even if the strengths differ so much that one of the
// probabilities rounds to 1.
PredictedGame predicted_game(double strength_a, double strength_b) {
  const double gap = std::abs(strength_a - strength_b);
  const double odds = std::exp(-gap);  // odds of the weaker team
  const double log_strong = -std::log1p(odds);
  const double strong = 1 / (1 + odds);
  const double weak = odds / (1 + odds);
  if (strength_a >= strength_b) return {strong, strong * weak, log_strong, log_strong - gap};
  return {weak, strong * weak, log_strong - gap, log_strong};
}

std::vector<MatchupTotals> with_games(std::span<const MatchupTotals> totals) {
  std::vector<MatchupTotals> matchups;
  for (const MatchupTotals& matchup : totals) {
    if (matchup.games > 0) matchups.push_back(matchup);
  }
  return matchups;
}

double log_determinant(const Eigen::LLT<MatrixXd>& factor) {
  return 2 * factor.matrixLLT().diagonal().array().log().sum();
}

// x' I^-1 x n p (1 - p), a matchup's share in determining the strengths, from the inverse of I. The
// leverages sum to the number of teams minus that of groups.
double leverage_of(const MatchupTotals& matchup, double weight, const MatrixXd& inverse) {
  return weight * (inverse(matchup.a, matchup.a) + inverse(matchup.b, matchup.b) -
                   2 * inverse(matchup.a, matchup.b));
}

// Fisher's information, made positive definite by group_means().
MatrixXd information_of(const std::vector<MatchupTotals>& matchups,
                        const std::vector<PredictedGame>& games, MatrixXd means) {
  for (std::size_t i = 0; i < games.size(); ++i) {
    add_to_normal_equations(means, matchups[i], matchups[i].games * games[i].variance);
  }
  return means;
}

// Adds the derivatives of the penalised likelihood. The penalty acts as if each matchup had
// additional drawn games, as many as its leverage.
void add_derivatives(LikelihoodPoint& point, const std::vector<MatchupTotals>& matchups,
                     const std::vector<PredictedGame>& games, MatrixXd information,
                     const MatrixXd& inverse) {
  for (std::size_t i = 0; i < games.size(); ++i) {
    const MatchupTotals& matchup = matchups[i];
    const double leverage = leverage_of(matchup, matchup.games * games[i].variance, inverse);
    const double more_wins =
        matchup.wins + leverage / 2 - (matchup.games + leverage) * games[i].win;
    point.score(matchup.a) += more_wins;
    point.score(matchup.b) -= more_wins;
    add_to_normal_equations(information, matchup, leverage * games[i].variance);
  }
  point.curvature.compute(information);
}

}  // namespace

VectorXd shortened_step(const VectorXd& step) {
  const double longest = step.size() == 0 ? 0 : step.cwiseAbs().maxCoeff();
  if (longest <= kLongestStep) return step;
  return step * (kLongestStep / longest);
}

PenalisedLikelihood::PenalisedLikelihood(std::size_t teams, std::span<const MatchupTotals> totals)
    : matchups_(with_games(totals)),
      groups_(linked_groups(teams, totals)),
      group_means_(group_means(groups_)) {}

VectorXd PenalisedLikelihood::direction_of(std::size_t team) const {
  VectorXd direction = -group_means_.col(team);
  direction(team) += 1;
  return direction;
}

LikelihoodPoint PenalisedLikelihood::at(const VectorXd& strengths) const {
  LikelihoodPoint point{strengths, 0, VectorXd::Zero(strengths.size()), {}, 0};
  std::vector<PredictedGame> games;
  games.reserve(matchups_.size());
  for (const MatchupTotals& matchup : matchups_) {
    const PredictedGame& game =
        games.emplace_back(predicted_game(strengths(matchup.a), strengths(matchup.b)));
    point.value += matchup.wins * game.log_win + (matchup.games - matchup.wins) * game.log_loss;
    point.win_variance += matchup.games * game.variance;
  }
  const MatrixXd information = information_of(matchups_, games, group_means_);
  const Eigen::LLT<MatrixXd> factor(information);
  point.value += log_determinant(factor) / 2;
  if (factor.info() != Eigen::Success || !std::isfinite(point.value)) {
    point.value = -std::numeric_limits<double>::infinity();
    return point;
  }
  const MatrixXd identity = MatrixXd::Identity(information.rows(), information.cols());
  add_derivatives(point, matchups_, games, information, factor.solve(identity));
  return point;
}

LikelihoodPoint PenalisedLikelihood::maximum() const {
  LikelihoodPoint best = at(VectorXd::Zero(groups_.size()));
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    VectorXd step = shortened_step(best.curvature.solve(best.score));
    const double least = best.value - kRelativeRounding * (1 + std::abs(best.value));
    LikelihoodPoint next = at(best.strengths + step);
    for (int j = 0; j < kMostHalvings && next.value < least; ++j) {
      step /= 2;
      next = at(best.strengths + step);
    }
    if (next.value < least) break;
    best = std::move(next);
    if (step.size() == 0 || step.cwiseAbs().maxCoeff() < kSmallStep) break;
  }
  return best;
}

Eigen::VectorXd bradley_terry(std::size_t teams, std::span<const MatchupTotals> totals) {
  return PenalisedLikelihood(teams, totals).maximum().strengths;
}

Eigen::VectorXd goal_rating(std::size_t teams, std::span<const MatchupTotals> totals) {
  Eigen::MatrixXd equations = group_means(linked_groups(teams, totals));
  Eigen::VectorXd differences = Eigen::VectorXd::Zero(teams);
  for (const MatchupTotals& matchup : totals) {
    if (!(matchup.games > 0)) continue;
    add_to_normal_equations(equations, matchup, matchup.games);
    differences(matchup.a) += matchup.difference;
    differences(matchup.b) -= matchup.difference;
  }
  return equations.llt().solve(differences);
}

}  // namespace autoref::experiments
