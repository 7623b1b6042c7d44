#include "runner/statistics/bradley_terry.hpp"

#include <Eigen/QR>
#include <cmath>
#include <vector>

namespace autoref::runner {
namespace {

constexpr int kMostSteps = 100;
constexpr int kMostHalvings = 30;
constexpr double kSmallStep = 1e-10;

using Totals = std::vector<MatchupTotals>;
using Eigen::VectorXd;

Totals with_a_draw_more(std::span<const MatchupTotals> totals) {
  Totals played;
  for (MatchupTotals matchup : totals) {
    if (!(matchup.games > 0)) continue;
    matchup.games += 1;
    matchup.wins += 0.5;
    played.push_back(matchup);
  }
  return played;
}

double chance_of_a(const MatchupTotals& matchup, const VectorXd& strengths) {
  return 1 / (1 + std::exp(strengths(matchup.b) - strengths(matchup.a)));
}

double log_likelihood(const Totals& totals, const VectorXd& strengths) {
  double sum = 0;
  for (const MatchupTotals& matchup : totals) {
    const double chance = chance_of_a(matchup, strengths);
    sum += matchup.wins * std::log(chance) + (matchup.games - matchup.wins) * std::log1p(-chance);
  }
  return sum;
}

// Solves H step = g with the gradient g of the log-likelihood and its negated Hessian H.
VectorXd newton_step(const Totals& totals, const VectorXd& strengths) {
  VectorXd slope = VectorXd::Zero(strengths.size());
  Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(strengths.size(), strengths.size());
  for (const MatchupTotals& matchup : totals) {
    const double chance = chance_of_a(matchup, strengths);
    const double more_wins = matchup.wins - matchup.games * chance;
    const double weight = matchup.games * chance * (1 - chance);
    slope(matchup.a) += more_wins;
    slope(matchup.b) -= more_wins;
    curvature(matchup.a, matchup.a) += weight;
    curvature(matchup.b, matchup.b) += weight;
    curvature(matchup.a, matchup.b) -= weight;
    curvature(matchup.b, matchup.a) -= weight;
  }
  // H is singular, since adding a constant to all strengths changes nothing. Take the
  // minimum-norm step, whose sum is zero.
  return curvature.completeOrthogonalDecomposition().solve(slope);
}

// Backtracking line search. The negated comparison also rejects a likelihood that is not a number.
VectorXd improved(const Totals& totals, const VectorXd& strengths, VectorXd step) {
  const double before = log_likelihood(totals, strengths);
  for (int i = 0; i < kMostHalvings && !(log_likelihood(totals, strengths + step) >= before); ++i) {
    step /= 2;
  }
  return strengths + step;
}

}  // namespace

VectorXd bradley_terry(std::size_t teams, std::span<const MatchupTotals> totals) {
  const Totals games = with_a_draw_more(totals);
  VectorXd strengths = VectorXd::Zero(teams);
  if (games.empty()) return strengths;
  for (int i = 0; i < kMostSteps; ++i) {
    const VectorXd step = newton_step(games, strengths);
    strengths = improved(games, strengths, step);
    if (step.cwiseAbs().maxCoeff() < kSmallStep) break;
  }
  return strengths;
}

}  // namespace autoref::runner
