#include "logs/fit/chip_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>
#include <utility>

#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

void keep_better_kick(std::optional<KickSolution>& best, std::optional<KickSolution> other) {
  if (other && (!best || other->misfit < best->misfit)) best = std::move(other);
}

KickUnknowns extended(const KickUnknowns& unknowns, std::initializer_list<double> further) {
  KickUnknowns all(unknowns.size() + static_cast<Eigen::Index>(further.size()));
  all.head(unknowns.size()) = unknowns;
  std::copy(further.begin(), further.end(), all.data() + unknowns.size());
  return all;
}

// Begins with the mean velocity until `end_s`.
KickUnknowns first_kick_guess(const KickedBall& ball, double end_s) {
  const auto sights = sights_until(ball, end_s);
  const KickedSight& last = sights.empty() ? ball.sights.front() : sights.back();
  KickUnknowns guess(kModel);
  guess << ball.rest_m, (last.position_m - ball.rest_m) / last.since_s, ball.interval_s / 2;
  return guess;
}

// The time since the last detection before the kick at which the ball has flown as long as `hops`
// times its first flight.
double hop_end_s(const KickUnknowns& u, double hops) {
  return u[kStart] + flight_duration_s(u[kVz]) * hops;
}

// A fit of the hops may be worse than that of the flight before, but not by more than this factor.
bool is_as_good_as(const KickSolution& former, const KickSolution& solution) {
  constexpr double kGrowth = 1.8;
  return solution.misfit < kGrowth * std::max(1.0, former.misfit);
}

// The flight until shortly before its guessed end.
std::optional<KickSolution> flight_of(const KickedBall& ball) {
  constexpr std::array kRiseGuesses_mps = {1.5, 2.5, 3.5, 4.5};
  constexpr double kLeastRise_mps = 0.9;
  constexpr double kMostRise_mps = 6;
  constexpr double kShare = 0.95;
  constexpr double kMostMisfit = 2.5;
  std::optional<KickSolution> best;
  for (const double rise_mps : kRiseGuesses_mps) {
    const double end_s = kShare * flight_duration_s(rise_mps);
    auto flight =
        fit_kick(ball, chipped_ball, end_s, extended(first_kick_guess(ball, end_s), {rise_mps}));
    if (flight && flight->unknowns[kVz] > kLeastRise_mps && flight->unknowns[kVz] < kMostRise_mps)
      keep_better_kick(best, std::move(flight));
  }
  if (best && best->misfit > kMostMisfit) best.reset();
  return best;
}

// Whether a path on the carpet explains the detections much worse than the flight.
bool is_flying(const KickedBall& ball, const KickSolution& flight) {
  constexpr double kConvincing = 5;  // ratio of the misfits
  const double end_s = hop_end_s(flight.unknowns, 1);
  std::optional<KickSolution> carpet;
  for (const double sliding_share : {0.25, 0.75}) {
    keep_better_kick(
        carpet,
        fit_kick(ball, ball_on_carpet, end_s,
                 extended(first_kick_guess(ball, end_s),
                          {kUsualBall.slide_mps2, kUsualBall.roll_mps2, sliding_share * end_s})));
  }
  return !carpet || carpet->misfit > kConvincing * std::max(1.0, flight.misfit);
}

// The flight and most of the first hop, or less of it if the ball soon meets something.
std::optional<KickSolution> first_hop_of(const KickedBall& ball, const KickSolution& flight) {
  constexpr std::array kFirstZGuesses = {0.45, 0.6};
  for (const double share : {0.9, 0.6, 0.4}) {
    std::optional<KickSolution> best;
    for (const double first_z : kFirstZGuesses) {
      const double end_s = hop_end_s(flight.unknowns, 1 + share * first_z);
      keep_better_kick(best,
                       fit_kick(ball, chipped_ball, end_s,
                                extended(flight.unknowns, {kUsualBall.hop_first_xy, first_z})));
    }
    if (best && is_as_good_as(flight, *best)) return best;
  }
  return std::nullopt;
}

// The flight, the first hop and a little of the path after it.
std::optional<KickSolution> second_landing_of(const KickedBall& ball, const KickSolution& hop) {
  constexpr double kAfterHop_s = 0.16;
  constexpr int kLeastAfterHop = 6;
  const double landing_s = hop_end_s(hop.unknowns, 1 + hop.unknowns[kFirstZ]);
  const double end_s = landing_s + kAfterHop_s;
  const auto sights = sights_until(ball, end_s);
  if (std::count_if(sights.begin(), sights.end(), [&](const KickedSight& sight) {
        return sight.since_s > landing_s;
      }) < kLeastAfterHop)
    return std::nullopt;
  auto landing =
      fit_kick(ball, chipped_ball, end_s, extended(hop.unknowns, {kUsualBall.hop_later_xy}));
  if (landing && !is_as_good_as(hop, *landing)) landing.reset();
  return landing;
}

Measured elevation_deg(const KickSolution& fit) {
  constexpr double kDegrees = 1 / to_radians(1);
  const Vec2 velocity_mps = fit.unknowns.segment<2>(kVx);
  const double rise_mps = fit.unknowns[kVz];
  const double speed_mps = velocity_mps.norm();
  KickUnknowns gradient = KickUnknowns::Zero(fit.unknowns.size());
  gradient.segment<2>(kVx) = -velocity_mps * (rise_mps / speed_mps);
  gradient[kVz] = speed_mps;
  gradient /= square(speed_mps) + square(rise_mps);
  return {std::atan2(rise_mps, speed_mps) * kDegrees,
          std::sqrt(gradient.dot(fit.covariance * gradient)) * kDegrees};
}

bool is_precise_chip(const Measured& kept) { return kept.deviation < 0.06; }
// Along the carpet, a landing neither accelerates the ball nor stops it.
bool is_possible_xy(const Measured& kept) {
  return is_precise_chip(kept) && kept.value > 0.45 && kept.value < 1.02;
}
bool is_possible_z(const Measured& kept) { return kept.value > 0.15 && kept.value < 0.85; }

// The chip whose flight and first hop are `hop`. Returns nullopt if its bounce is impossible: then
// the ball met something.
std::optional<Chip> chip_from(const KickedBall& ball, const KickSolution& hop) {
  const Measured first_z = hop.measured(kFirstZ);
  Chip chip{elevation_deg(hop), hop.measured(kFirstXy), std::nullopt, std::nullopt};
  if (!is_possible_xy(chip.first_xy)) return std::nullopt;
  if (is_precise_chip(first_z) && !is_possible_z(first_z)) return std::nullopt;
  if (is_precise_chip(first_z)) chip.first_z = first_z;
  if (!chip.first_z) return chip;
  if (const auto landing = second_landing_of(ball, hop)) {
    const Measured later_xy = landing->measured(kLaterXy);
    if (is_possible_xy(later_xy)) chip.later_xy = later_xy;
  }
  return chip;
}

}  // namespace

std::optional<ChipPath> chip_path_of(const KickedBall& ball) {
  if (ball.sights.empty()) return std::nullopt;
  const auto flight = flight_of(ball);
  if (!flight || !is_flying(ball, *flight)) return std::nullopt;
  const auto hop = first_hop_of(ball, *flight);
  if (!hop) return ChipPath{hop_end_s(flight->unknowns, 1), std::nullopt};
  return ChipPath{hop_end_s(hop->unknowns, 1), chip_from(ball, *hop)};
}

}  // namespace autoref::logs
