// Evolution strategy with covariance matrix adaptation, the (mu/mu_w, lambda)-CMA-ES of Hansen, The
// CMA evolution strategy: a tutorial, arXiv:1604.00772 (2016), with the tutorial's default
// parameters (its table 1, without negative weights).
//
// Each iteration scores lambda points drawn from a normal distribution, and moves and reshapes that
// distribution towards the better half of them. It learns which parameters act together, but needs
// more points per iteration than SPSA.
#pragma once

#include <vector>

#include "experiments/tune/optimiser.hpp"

namespace autoref::experiments {

// Constants of the strategy for a number of parameters; names as in the tutorial.
struct CmaConstants {
  explicit CmaConstants(int parameters);

  int lambda = 0;  // candidates per iteration
  // Weights of the mu best candidates, in descending order; their sum is 1.
  Eigen::VectorXd weights;
  double mu_eff = 0;
  double c_sigma = 0;
  double d_sigma = 0;
  double c_c = 0;
  double c_1 = 0;
  double c_mu = 0;
  double chi_n = 0;  // expected length of a standard normal vector
};

class CmaEs : public Optimiser {
 public:
  // Starts with a standard deviation of one step in every parameter.
  CmaEs(std::vector<Axis> axes, std::uint64_t seed);

  // Candidates "x01", "x02", ... Points outside the box are clipped for scoring.
  std::vector<Candidate> ask() const override;

  // Candidates without a score rank last. A candidate that had to be clipped gets a lower score, in
  // proportion to the square of its distance from the box, so that the distribution stays near the
  // box (tutorial, B.5).
  void tell(std::span<const Score> scores) override;

  // The mean of the distribution, clipped.
  Point centre() const override;

  // The mean of the centres in the last half of the iterations so far. The best point is not the
  // candidate with the best score, because that candidate was mainly lucky.
  Point best() const override { return tail_.value(); }

  double reach() const override { return sigma_; }

 private:
  // The samples of this iteration, one per column: (x - mean) / sigma, which is y in the tutorial.
  Eigen::MatrixXd samples() const;
  std::vector<int> ranked(std::span<const Score> scores, const Eigen::MatrixXd& y) const;
  void adapt(const Eigen::MatrixXd& y, const std::vector<int>& order);
  void decompose();

  std::vector<Axis> axes_;
  std::uint64_t seed_;
  CmaConstants constants_;
  int iteration_ = 0;
  Point mean_;
  double sigma_ = 1;
  Eigen::MatrixXd covariance_;
  Eigen::MatrixXd directions_;  // eigenvectors of the covariance
  Eigen::VectorXd lengths_;     // square roots of the covariance's eigenvalues
  Point path_c_;
  Point path_sigma_;
  TailMean tail_;
};

}  // namespace autoref::experiments
