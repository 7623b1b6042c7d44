#include "experiments/tune/spsa.hpp"

#include <cassert>
#include <cmath>

#include "experiments/tune/optimiser.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

constexpr double kGainExponent = 0.602;          // Spall's alpha
constexpr double kPerturbationExponent = 0.101;  // Spall's gamma
constexpr double kStability = 0.1;               // A as a fraction of the iterations
constexpr double kLongestMove = 2;               // longest move of the centre, in perturbations

}  // namespace

double SpsaGains::perturbation(int k) const { return std::pow(k + 1.0, -kPerturbationExponent); }

double SpsaGains::gain_in(int k) const {
  // At first, a difference of 1 between points two perturbations apart is a gradient of 1/2.
  const double stability = kStability * iterations;
  return 2 * gain * std::pow((1 + stability) / (k + 1 + stability), kGainExponent);
}

Spsa::Spsa(const SpsaGains& gains, std::vector<Axis> axes, std::uint64_t seed)
    : gains_(gains),
      axes_(std::move(axes)),
      seed_(seed),
      centre_(start_of(axes_)),
      tail_(centre_) {}

Point Spsa::perturbation() const {
  RandomStream random(mix_bits(seed_) + static_cast<std::uint64_t>(iteration_));
  Point point(centre_.size());
  for (Eigen::Index i = 0; i < point.size(); ++i) {
    const double sign = random.uniform() < 0.5 ? -1 : 1;
    const double least = axes_[static_cast<std::size_t>(i)].least_perturbation;
    point[i] = sign * std::max(gains_.perturbation(iteration_), least);
  }
  return point;
}

std::vector<Candidate> Spsa::ask() const {
  const Point by = perturbation();
  return {{"plus", clipped(centre_ + by, axes_)}, {"minus", clipped(centre_ - by, axes_)}};
}

void Spsa::move_by(double difference) {
  squares_ += difference * difference;
  ++differences_;
  if (!(squares_ > 0)) return;
  const double relative = difference / std::sqrt(squares_ / differences_);
  const std::vector<Candidate> candidates = ask();
  const Point apart = candidates[0].point - candidates[1].point;  // nowhere 0: the box has a width
  const double most = kLongestMove * gains_.perturbation(iteration_);
  const Point move = gains_.gain_in(iteration_) * relative * apart.cwiseInverse();
  centre_ = clipped(centre_ + move.cwiseMax(-most).cwiseMin(most), axes_);
}

void Spsa::tell(std::span<const Score> scores) {
  assert(scores.size() == 2);
  if (scores[0] && scores[1]) move_by(*scores[0] - *scores[1]);
  ++iteration_;
  tail_.add(centre_);
}

}  // namespace autoref::experiments
