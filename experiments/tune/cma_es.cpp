#include "experiments/tune/cma_es.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "experiments/tune/optimiser.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

// Bounds that only a degenerate search reaches: all scores equal, or unbounded growth.
constexpr double kLeastLength = 1e-9;
constexpr double kLeastSigma = 1e-6;
constexpr double kMostSigma = 1e3;

// Standard deviation of the known scores, but at least a small positive value. This deviation is
// the unit of the penalty for a clipped distance.
double spread_of(std::span<const Score> scores) {
  double sum = 0, squares = 0;
  int count = 0;
  for (const Score& score : scores) {
    if (!score) continue;
    sum += *score;
    squares += *score * *score;
    ++count;
  }
  if (count < 2) return 1;
  const double variance = (squares - sum * sum / count) / (count - 1);
  return std::sqrt(std::max(variance, 1e-6));
}

}  // namespace

CmaConstants::CmaConstants(int parameters) {
  const double n = parameters;
  lambda = 4 + static_cast<int>(3 * std::log(n));
  const int mu = lambda / 2;
  weights.resize(mu);
  for (int i = 0; i < mu; ++i) weights[i] = std::log((lambda + 1) / 2.0) - std::log(i + 1.0);
  weights /= weights.sum();
  mu_eff = 1 / weights.squaredNorm();
  c_sigma = (mu_eff + 2) / (n + mu_eff + 5);
  d_sigma = 1 + 2 * std::max(0.0, std::sqrt((mu_eff - 1) / (n + 1)) - 1) + c_sigma;
  c_c = (4 + mu_eff / n) / (n + 4 + 2 * mu_eff / n);
  c_1 = 2 / ((n + 1.3) * (n + 1.3) + mu_eff);
  c_mu = std::min(1 - c_1, 2 * (mu_eff - 2 + 1 / mu_eff) / ((n + 2) * (n + 2) + mu_eff));
  chi_n = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
}

CmaEs::CmaEs(std::vector<Axis> axes, std::uint64_t seed)
    : axes_(std::move(axes)),
      seed_(seed),
      constants_(static_cast<int>(axes_.size())),
      mean_(start_of(axes_)),
      covariance_(Eigen::MatrixXd::Identity(mean_.size(), mean_.size())),
      path_c_(Point::Zero(mean_.size())),
      path_sigma_(Point::Zero(mean_.size())),
      tail_(mean_) {
  decompose();
}

Eigen::MatrixXd CmaEs::samples() const {
  RandomStream random(mix_bits(seed_) + static_cast<std::uint64_t>(iteration_));
  Eigen::MatrixXd normal(mean_.size(), constants_.lambda);
  for (Eigen::Index k = 0; k < normal.cols(); ++k) {
    for (Eigen::Index i = 0; i < normal.rows(); ++i) normal(i, k) = random.normal();
  }
  return directions_ * lengths_.asDiagonal() * normal;
}

std::vector<Candidate> CmaEs::ask() const {
  const Eigen::MatrixXd y = samples();
  std::vector<Candidate> candidates;
  candidates.reserve(static_cast<std::size_t>(y.cols()));
  for (Eigen::Index k = 0; k < y.cols(); ++k) {
    candidates.push_back({fmt::format("x{:02}", k + 1), clipped(mean_ + sigma_ * y.col(k), axes_)});
  }
  return candidates;
}

// The candidates' indices, the best candidate first; tied candidates keep their order.
std::vector<int> CmaEs::ranked(std::span<const Score> scores, const Eigen::MatrixXd& y) const {
  const double price = spread_of(scores);
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(y.cols()));
  for (Eigen::Index k = 0; k < y.cols(); ++k) {
    const Point x = mean_ + sigma_ * y.col(k);
    const double outside = (x - clipped(x, axes_)).squaredNorm() / (sigma_ * sigma_);
    const Score& score = scores[static_cast<std::size_t>(k)];
    values.push_back(score ? *score - price * outside : -std::numeric_limits<double>::infinity());
  }
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&values](int one, int other) {
    return values[static_cast<std::size_t>(one)] > values[static_cast<std::size_t>(other)];
  });
  return order;
}

// Equations (38) to (47) of the tutorial.
void CmaEs::adapt(const Eigen::MatrixXd& y, const std::vector<int>& order) {
  const CmaConstants& c = constants_;
  Point step = Point::Zero(mean_.size());
  Eigen::MatrixXd rank_mu = Eigen::MatrixXd::Zero(mean_.size(), mean_.size());
  for (Eigen::Index i = 0; i < c.weights.size(); ++i) {
    const auto of_rank = y.col(order[static_cast<std::size_t>(i)]);
    step += c.weights[i] * of_rank;
    rank_mu += c.weights[i] * of_rank * of_rank.transpose();
  }
  mean_ += sigma_ * step;
  const Point whitened =
      directions_ * lengths_.cwiseInverse().asDiagonal() * directions_.transpose() * step;
  path_sigma_ =
      (1 - c.c_sigma) * path_sigma_ + std::sqrt(c.c_sigma * (2 - c.c_sigma) * c.mu_eff) * whitened;
  const double length = path_sigma_.norm();
  const double fading = std::sqrt(1 - std::pow(1 - c.c_sigma, 2 * (iteration_ + 1)));
  const auto n = static_cast<double>(mean_.size());
  const double is_short = length / fading < (1.4 + 2 / (n + 1)) * c.chi_n ? 1 : 0;  // h_sigma
  path_c_ = (1 - c.c_c) * path_c_ + is_short * std::sqrt(c.c_c * (2 - c.c_c) * c.mu_eff) * step;
  const double kept = 1 + c.c_1 * (1 - is_short) * c.c_c * (2 - c.c_c) - c.c_1 - c.c_mu;
  covariance_ = kept * covariance_ + c.c_1 * path_c_ * path_c_.transpose() + c.c_mu * rank_mu;
  sigma_ *= std::exp(std::min(1.0, c.c_sigma / c.d_sigma * (length / c.chi_n - 1)));
  sigma_ = std::clamp(sigma_, kLeastSigma, kMostSigma);
}

void CmaEs::decompose() {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance_);
  directions_ = solver.eigenvectors();
  lengths_ = solver.eigenvalues().cwiseMax(0).cwiseSqrt().cwiseMax(kLeastLength);
}

void CmaEs::tell(std::span<const Score> scores) {
  assert(scores.size() == static_cast<std::size_t>(constants_.lambda));
  const Eigen::MatrixXd y = samples();
  adapt(y, ranked(scores, y));
  decompose();
  ++iteration_;
  tail_.add(centre());
}

Point CmaEs::centre() const { return clipped(mean_, axes_); }

}  // namespace autoref::experiments
