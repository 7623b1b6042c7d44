#include "logs/fit/contact_fit.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace autoref::logs {
namespace {

constexpr std::size_t kEnoughBounces = 6;
// How far estimates from simulated games are off, beyond what the bootstrap says.
constexpr double kBounceError = 0.05;

void append(const std::vector<Bounce>& bounces, std::vector<Bounce>& all) {
  all.insert(all.end(), bounces.begin(), bounces.end());
}

Estimate restitution_of(const std::vector<Bounce>& bounces) {
  const auto estimator = [&](std::span<const std::size_t> groups) -> std::optional<double> {
    std::vector<double> values;
    std::vector<double> weights;
    values.reserve(groups.size());
    weights.reserve(groups.size());
    for (const std::size_t group : groups) {
      values.push_back(bounces[group].restitution);
      weights.push_back(bounces[group].weight);
    }
    return weighted_median(values, weights);
  };
  return {static_cast<std::int64_t>(bounces.size()),
          bootstrap_estimate(bounces.size(), kEnoughBounces, kBounceError, estimator)};
}

}  // namespace

void ContactFit::add(const RecordedMotion& motion) {
  append(wall_bounces_in(motion, ball_), off_walls_);
  append(body_bounces_in(motion, ball_), off_bodies_);
}

Estimate ContactFit::wall_restitution() const { return restitution_of(off_walls_); }

Estimate ContactFit::body_restitution() const { return restitution_of(off_bodies_); }

}  // namespace autoref::logs
