// Team strengths estimated from wins, with the likelihood of the Bradley-Terry model and Firth's
// penalty, and ratings estimated from goal differences.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "experiments/statistics/rated_games.hpp"

namespace autoref::experiments {

// The penalised likelihood at one point.
struct LikelihoodPoint {
  Eigen::VectorXd strengths;
  // Logarithm of the penalised likelihood. If it is not finite, this is -infinity, and the
  // derivatives are not computed.
  double value = 0;
  Eigen::VectorXd score;                  // first derivatives of `value`
  Eigen::LLT<Eigen::MatrixXd> curvature;  // approximates the negated second derivatives of `value`
  double win_variance = 0;  // sum of n p (1 - p): variance of wins if no game is drawn
};

// Shortens a step so that it changes no strength by more than 2. A longer step may end at strengths
// for which all results are practically certain, where rounding errors would determine the next
// step.
Eigen::VectorXd shortened_step(const Eigen::VectorXd& step);

// In the Bradley-Terry model (Rank analysis of incomplete block designs, Biometrika 39, 1952), team
// a beats b with probability p = 1 / (1 + exp(strength of b - strength of a)). A draw counts as
// half a win for each team. The likelihood L of the games is multiplied by the root of the
// determinant of Fisher's information I (Firth, Bias reduction of maximum likelihood estimates,
// Biometrika 80, 1993; the same as Jeffreys' prior):
//
//     log L* = log L + 1/2 log det I,    I = sum of n p (1 - p) x x' over the matchups
//
// with n games in a matchup, and x = 1 for team a, -1 for b. The determinant is that on the space
// of strengths that sum to zero in each group of teams linked by games. L* has a finite maximum
// although L has none if, say, a team won all its games.
class PenalisedLikelihood {
 public:
  // `totals` contains each matchup once. Matchups without games have no effect.
  PenalisedLikelihood(std::size_t teams, std::span<const MatchupTotals> totals);

  // The number of each team's group; see linked_groups().
  const std::vector<std::size_t>& groups() const { return groups_; }

  // All matchups with games.
  const std::vector<MatchupTotals>& matchups() const { return matchups_; }

  // The direction that moves a team relative to the mean of its group: 1 for the team, minus the
  // mean of this vector over the group.
  Eigen::VectorXd direction_of(std::size_t team) const;

  // The likelihood for `strengths` that sum to zero in each group.
  LikelihoodPoint at(const Eigen::VectorXd& strengths) const;

  // The point of maximum likelihood, found by Newton's method from equal strengths. Steps are
  // shortened and halved until the likelihood does not fall. Stops when a step changes every
  // strength by less than 1e-10, and after at most 200 steps. The second derivatives treat the
  // leverages as constant.
  LikelihoodPoint maximum() const;

 private:
  std::vector<MatchupTotals> matchups_;
  std::vector<std::size_t> groups_;
  Eigen::MatrixXd group_means_;
};

// Strengths of `teams` teams such that a beats b with probability 1 / (1 + exp(strength of b -
// strength of a)), where the likelihood with Firth's penalty is largest (see PenalisedLikelihood).
// A draw counts as half a win for each team. Strengths of teams linked by games sum to zero;
// strengths of unlinked groups of teams cannot be compared. `totals` contains each matchup once.
//
// The strength of a team that won all its games would be infinite without the penalty, which
// shrinks it: for two teams, half a win is added to each, and 40 wins in 40 games give a difference
// of log(40.5 / 0.5) = 4.4.
Eigen::VectorXd bradley_terry(std::size_t teams, std::span<const MatchupTotals> totals);

// Ratings of `teams` teams such that the expected goal difference of a game is the difference of
// the two ratings: least squares over all games. Ratings of teams linked by games sum to zero;
// ratings of unlinked groups of teams cannot be compared. `totals` contains each matchup once; a
// matchup without games has no effect.
Eigen::VectorXd goal_rating(std::size_t teams, std::span<const MatchupTotals> totals);

}  // namespace autoref::experiments
