#include "tracking/chip_flight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/simulated_kicks.hpp"

namespace autoref::tracking {
namespace {

// A chip with a closed-form solution: 5 m/s at 45 degrees first lands v²/g = 2.548 m away.
Kick chip_along(const Vec2& from_m, const Vec2& along) {
  return {0.01, from_m, along, 5 / std::sqrt(2.0), 5 / std::sqrt(2.0)};
}

// The estimate at `time_s` from noiseless detections without gaps.
ChipEstimate clean_estimate(const Kick& kick, double time_s) {
  ChipFlight flight(0);
  flight.begin({kick.time_s, 5_mm, kick.from_m, 0});
  for (int n = 1; n / 60.0 <= time_s; ++n) flight.add(seen(truth_at(kick, n / 60.0), n / 60.0));
  return flight.estimate();
}

TEST(ChipFlight, MatchesTheClosedFormOfAFlight) {
  const ChipEstimate e = clean_estimate(chip_along({0.5, 0.5}, {0.8, 0.6}), 0.35);
  EXPECT_EQ(e.flight, BallFlight::kFlying);
  EXPECT_NEAR(e.height_m, 3.5355 * 0.34 - 4.905 * 0.34 * 0.34, 2_mm);
  EXPECT_NEAR(e.vertical_speed_mps, 3.5355 - 9.81 * 0.34, 0.01);
  EXPECT_NEAR(e.landing_s, 0.01 + 0.7208, 0.002);
  EXPECT_NEAR((e.landing_m - Vec2(0.5, 0.5)).norm(), 2.548, 5_mm);
}

TEST(ChipFlight, ContinuesAcrossACameraHandover) {
  const Kick kick = chip_along({-0.8, 0.7}, {1, 0});  // over the halfway line after 0.23 s
  const ChipEstimate e = clean_estimate(kick, 0.5);
  EXPECT_EQ(e.flight, BallFlight::kFlying);
  EXPECT_NEAR(e.height_m, 3.5355 * 0.49 - 4.905 * 0.49 * 0.49, 2_mm);
}

TEST(ChipFlight, ClassifiesAStraightKickAsOnTheGroundPermanently) {
  Kick kick = chip_along({0.5, 0.5}, {0.8, 0.6});
  kick.rise_mps = 0;
  EXPECT_EQ(clean_estimate(kick, 0.2).flight, BallFlight::kOnGround);
  EXPECT_EQ(clean_estimate(kick, 1.0).flight, BallFlight::kOnGround);
}

TEST(ChipFlight, IsUnknownWhileTheBallBouncesThenOnTheGround) {
  const Kick kick = chip_along({-2, 0.5}, {1, 0});
  EXPECT_EQ(clean_estimate(kick, 0.80).flight, BallFlight::kUnknown);
  EXPECT_EQ(clean_estimate(kick, 1.35).flight, BallFlight::kUnknown);
  EXPECT_EQ(clean_estimate(kick, 1.75).flight, BallFlight::kOnGround);
}

// Detections of a ball that rolls at 1 m/s for two seconds.
void roll(ChipFlight& flight) {
  for (int n = 1; n < 120; ++n) flight.add({n / 60.0, {n / 60.0, 1}, {2, 1}, 4});
}

TEST(ChipFlight, IsUnknownBeforeAKickAndAfterTheNext) {
  ChipFlight flight(1.4_mm);
  EXPECT_EQ(flight.add({0, {1, 1}, {2, 1}, 4}).flight, BallFlight::kUnknown);
  roll(flight);
  EXPECT_EQ(flight.estimate().flight, BallFlight::kUnknown);
  flight.begin({2, 5_ms, {2, 1}, 1_mm});
  EXPECT_EQ(flight.estimate().flight, BallFlight::kUnknown);
}

// A robot in the way deflects the ball, which then falls.
// The flight of a chip, seen for a quarter of a second.
ChipFlight flight_of(const Kick& kick) {
  ChipFlight flight(1_mm);
  flight.begin({kick.time_s, 5_ms, kick.from_m, 1_mm});
  for (int n = 1; n <= 15; ++n) flight.add(seen(truth_at(kick, n / 60.0), n / 60.0));
  return flight;
}

// The next three detections of a ball that is hit sideways at a quarter of a second.
void hit_sideways(ChipFlight& flight, const Truth& hit) {
  for (int n = 16; n <= 18; ++n) {
    flight.add(seen({hit.position_m + Vec2(0, (n - 15) / 60.0), hit.height_m}, n / 60.0));
  }
}

TEST(ChipFlight, GivesUpIfTheBallIsHitInTheAir) {
  const Kick kick = chip_along({-2, 0.5}, {1, 0});
  ChipFlight flight = flight_of(kick);
  ASSERT_EQ(flight.estimate().flight, BallFlight::kFlying);
  const Truth hit = truth_at(kick, 0.25);
  hit_sideways(flight, hit);
  EXPECT_EQ(flight.estimate().flight, BallFlight::kUnknown);
  const BallDetection later = seen({hit.position_m, 0}, 2.0);  // after all bounces would have ended
  EXPECT_EQ(flight.add(later).flight, BallFlight::kUnknown);
}

// After three detections of a kick a robot deflects the ball, and the next robot stops it.
TEST(ChipFlight, StaysUnknownBetweenTwoBadFitsUntilNothingCanFly) {
  ChipFlight flight(1.4_mm);
  flight.begin({0, 5_ms, {0.5, 0.5}, 1.4_mm});
  for (int n = 1; n <= 110; ++n) {
    const Vec2 path_m(0.08 * std::min(n, 3), 0.04 * std::clamp(n - 3, 0, 10));
    flight.add(seen({Vec2(0.5, 0.5) + path_m, 0}, n / 60.0));
    EXPECT_NE(flight.estimate().flight, BallFlight::kFlying) << n;
    EXPECT_NE(flight.estimate().flight, BallFlight::kOnGround) << n;
  }
  for (int n = 111; n <= 130; ++n) flight.add(seen({{0.74, 0.9}, 0}, n / 60.0));
  EXPECT_EQ(flight.estimate().flight, BallFlight::kOnGround);
}

TEST(ChipFlight, IsEquivariantUnderRotation) {
  const Kick kick = chip_along({0.5, 0.5}, {0.8, 0.6});
  const Kick turned = chip_along({-0.5, -0.5}, {-0.8, -0.6});
  const ChipEstimate a = clean_estimate(kick, 0.3);
  const ChipEstimate b = clean_estimate(turned, 0.3);
  EXPECT_EQ(a.position_m, -b.position_m);
  EXPECT_EQ(a.height_m, b.height_m);
  EXPECT_EQ(a.landing_m, -b.landing_m);
}

}  // namespace
}  // namespace autoref::tracking
