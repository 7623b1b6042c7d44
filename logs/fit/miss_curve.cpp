#include "logs/fit/miss_curve.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>

#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

// The logits of `far` and `near`, and the logarithm of `near_m`.
using MissCoordinates = Eigen::Vector3d;

const MissCoordinates kFirstGuess{-3.5, -1, std::log(80_mm)};
// Bounds where the data say nothing about a parameter.
const MissCoordinates kLowestGuess{-12, -12, std::log(5_mm)};
const MissCoordinates kHighestGuess{3, 6, std::log(1_m)};

constexpr int kMostSteps = 40;
constexpr double kLeastGain = 1e-6;  // of the log likelihood
constexpr double kFirstDamping = 1e-2;
constexpr double kMostDamping = 1e6;
constexpr double kTinyInformation = 1e-9;

double logistic(double x) { return 1 / (1 + std::exp(-x)); }

MissCurve curve_at(const MissCoordinates& at) {
  return {logistic(at[0]), logistic(at[1]), std::exp(at[2])};
}

struct Likelihood {
  double log = 0;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // Fisher's
};

Likelihood likelihood_at(const MissCoordinates& at, std::span<const GapBin> bins) {
  const MissCurve curve = curve_at(at);
  Likelihood result;
  for (const GapBin& bin : bins) {
    if (bin.frames == 0) continue;
    const double gaps = bin.sum_m / bin.frames / curve.near_m;
    const double share = curve.near * std::exp(-gaps);
    const double seen = (1 - curve.far) * (1 - share);
    const double missed = 1 - seen;
    const Eigen::Vector3d slope{curve.far * seen, (1 - curve.far) * share * (1 - curve.near),
                                (1 - curve.far) * share * gaps};
    result.log += bin.missed * std::log(missed) + (bin.frames - bin.missed) * std::log(seen);
    result.slope += (bin.missed - bin.frames * missed) / (missed * seen) * slope;
    result.information += bin.frames / (missed * seen) * slope * slope.transpose();
  }
  return result;
}

}  // namespace

// Fisher's scoring, damped as by Levenberg and Marquardt.
MissCurve fitted_miss_curve(std::span<const GapBin> bins) {
  MissCoordinates at = kFirstGuess;
  Likelihood likelihood = likelihood_at(at, bins);
  double damping = kFirstDamping;
  for (int step = 0; step < kMostSteps && damping < kMostDamping; ++step) {
    Eigen::Matrix3d damped = likelihood.information;
    damped.diagonal() *= 1 + damping;
    damped.diagonal().array() += kTinyInformation;
    const MissCoordinates next =
        (at + damped.ldlt().solve(likelihood.slope)).cwiseMax(kLowestGuess).cwiseMin(kHighestGuess);
    const Likelihood improved = likelihood_at(next, bins);
    if (improved.log < likelihood.log) {
      damping *= 10;
      continue;
    }
    const double gain = improved.log - likelihood.log;
    at = next;
    likelihood = improved;
    if (gain < kLeastGain) break;
    damping /= 10;
  }
  return curve_at(at);
}

}  // namespace autoref::logs
