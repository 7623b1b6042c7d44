// The ball's way while nothing but the carpet acts on it.
#include "referee/touch/free_way.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/random.hpp"

namespace autoref::referee {
namespace {

constexpr double kFrame_s = 1.0 / 60;
constexpr WayParameters kParameters;

// A ball that moves along x from the origin and is slowed evenly, seen without noise.
Vec2 slowed(double speed_mps, double slowed_by_mps2, double time_s) {
  return {speed_mps * time_s - slowed_by_mps2 / 2 * time_s * time_s, 0};
}

// A way that has taken in that ball, a sighting a frame, the last at `frames`.
FreeWay way_of(double speed_mps, double slowed_by_mps2, int frames, bool rolls = false) {
  FreeWay way;
  way.start({0, 0}, kParameters);
  for (int i = 1; i <= frames; ++i) {
    way.predict(kFrame_s, kParameters);
    if (rolls && i == 2) way.begin_to_roll(kParameters);
    way.correct(slowed(speed_mps, slowed_by_mps2, i * kFrame_s), kParameters);
  }
  return way;
}

double velocity_off_mps(const FreeWay& way) { return std::sqrt(way.velocity_variance_m2ps2()); }
double place_off_m(const FreeWay& way) { return std::sqrt(way.place_variance_after(0)); }

TEST(FreeWay, BeginsWithAVelocityThatMayBeAKicks) {
  FreeWay way;
  way.start({1, 2}, kParameters);
  EXPECT_EQ(way.place_after(0), Vec2(1, 2));
  EXPECT_EQ(way.velocity_mps(), Vec2(0, 0));
  // A kick of 8 m/s (Laws) is two deviations of it, or a little more.
  EXPECT_NEAR(velocity_off_mps(way), 4, 2);
}

TEST(FreeWay, KnowsTheVelocityFromTwoSightings) {
  const FreeWay way = way_of(3, 0, 1);
  EXPECT_NEAR(way.velocity_mps().x(), 3, 0.02);
  // Two sightings of 0.2 mm, and half a frame's friction: 17 mm/s each.
  EXPECT_NEAR(velocity_off_mps(way), 0.025, 0.01);
}

TEST(FreeWay, LearnsHowTheBallIsSlowedWhileItSlides) {
  const FreeWay way = way_of(4, 3.5, 15);
  EXPECT_NEAR(way.velocity_mps().x(), 4 - 3.5 * 15 * kFrame_s, 0.02);
  const double ahead_s = 0.1;
  EXPECT_NEAR(way.place_after(ahead_s).x(), slowed(4, 3.5, 15 * kFrame_s + ahead_s).x(), 0.003);
}

// A ball is slowed by 3.0 to 3.9 m/s2 while it slides: after ten frames the place is off by about
// half of that times the time squared, 30 to 55 mm, in two deviations.
TEST(FreeWay, IsUncertainByWhatSlidingMayTake) {
  FreeWay way = way_of(4, 0, 1);
  const FreeWay known = way;
  way.predict(10 * kFrame_s, kParameters);
  const double by_velocity_m = velocity_off_mps(known) * 10 * kFrame_s;
  const double off_m = std::sqrt(std::pow(place_off_m(way), 2) - std::pow(by_velocity_m, 2));
  EXPECT_GT(2 * off_m, 0.03);
  EXPECT_LT(2 * off_m, 0.12);
}

// Goes on unseen, frame by frame.
void go_unseen(FreeWay& way, double duration_s) {
  const int frames = static_cast<int>(duration_s / kFrame_s + 0.5);
  for (int i = 0; i < frames; ++i) way.predict(kFrame_s, kParameters);
}

// Within a second sliding may end, or the spin turn: friction becomes another one by 1 m/s2. Summed
// over that second, the velocity is off by that divided by the root of three.
TEST(FreeWay, ForgetsHowTheBallWasSlowed) {
  FreeWay way = way_of(4, 3.5, 60);
  go_unseen(way, 1);
  EXPECT_NEAR(velocity_off_mps(way), 1 / std::sqrt(3.0), 0.25);
}

// Carpets are even: within 4 s rolling is slowed by another 0.14 m/s2.
TEST(FreeWay, HardlyForgetsHowTheBallWasSlowedWhileItRolled) {
  FreeWay way = way_of(3, 0.3, 120, true);
  go_unseen(way, 4);
  EXPECT_NEAR(velocity_off_mps(way), 0.14 * 4 / std::sqrt(3.0), 0.15);
}

TEST(FreeWay, RollsOnSlowedByTheCarpet) {
  const FreeWay way = way_of(1, 0.3, 30, true);
  ASSERT_TRUE(way.rolls());
  const double ahead_s = 1;
  EXPECT_NEAR(way.place_after(ahead_s).x(), slowed(1, 0.3, 30 * kFrame_s + ahead_s).x(), 0.02);
}

// On the league's carpets a ball that rolls loses 0.1 to 0.5 m/s each second.
TEST(FreeWay, TakesABallThatBeginsToRollToBeSlowedAsOnAnyCarpet) {
  FreeWay way = way_of(2, 0, 30);
  way.begin_to_roll(kParameters);
  way.predict(1, kParameters);
  EXPECT_NEAR(way.velocity_mps().x(), 2 - 0.3, 0.02);
  // 0.2 m/s2 off for a second, and 20 mm/s by which sliding ended within a frame.
  EXPECT_NEAR(velocity_off_mps(way), 0.2, 0.08);
}

TEST(FreeWay, IsLittleChangedWhereRollingBegins) {
  FreeWay way = way_of(2, 0, 60);
  const double before_mps = velocity_off_mps(way);
  way.begin_to_roll(kParameters);
  const double grown_mps = std::sqrt(std::pow(velocity_off_mps(way), 2) - std::pow(before_mps, 2));
  // Sliding for a third of a frame: 3.5 m/s2 times 6 ms.
  EXPECT_NEAR(grown_mps, 0.02, 0.01);
}

TEST(FreeWay, ComesToRestWhereItRolls) {
  FreeWay way = way_of(0.1, 0.3, 12, true);
  way.predict(2, kParameters);
  const Vec2 rests_m = way.place_after(0);
  way.predict(2, kParameters);
  EXPECT_EQ(way.velocity_mps(), Vec2(0, 0));
  EXPECT_EQ(way.place_after(0), rests_m);
}

TEST(FreeWay, MayBeKickedByAHardTouch) {
  FreeWay way = way_of(1, 0, 30);
  way.touch(kFrame_s, false, kParameters);
  EXPECT_FALSE(way.rolls());
  // Bounces change about 1 m/s, kicks up to 8: those are five deviations.
  EXPECT_NEAR(velocity_off_mps(way), 1.5, 0.8);
}

TEST(FreeWay, RollsOnAfterASoftTouch) {
  FreeWay way = way_of(1, 0.3, 30, true);
  way.touch(kFrame_s, true, kParameters);
  EXPECT_TRUE(way.rolls());
  // A ball of 1 m/s that is turned by 8 degrees.
  EXPECT_NEAR(velocity_off_mps(way), 0.14, 0.06);
}

// A touch was at any time of the frame: the place is off by the new velocity for a part of it.
TEST(FreeWay, IsOffByATouchDuringTheFrame) {
  FreeWay way = way_of(1, 0, 30);
  const double before_m = place_off_m(way);
  way.touch(kFrame_s, false, kParameters);
  const double grown_m = std::sqrt(std::pow(place_off_m(way), 2) - std::pow(before_m, 2));
  EXPECT_NEAR(grown_m, 1.5 * kFrame_s / std::sqrt(3.0), 1e-3);
}

TEST(FreeWay, KnowsThePlaceOfABallThatBeginsToFlyToACentimetre) {
  FreeWay way;
  way.jump({0, 0}, kParameters);
  EXPECT_NEAR(place_off_m(way), 0.01, 0.005);
}

TEST(FreeWay, IsTheSameBackwards) {
  FreeWay way;
  way.start(slowed(3, 3.5, 10 * kFrame_s), kParameters);
  for (int i = 9; i >= 0; --i) {
    way.predict(-kFrame_s, kParameters);
    way.correct(slowed(3, 3.5, i * kFrame_s), kParameters);
  }
  EXPECT_NEAR(way.velocity_mps().x(), 3, 0.03);
  EXPECT_NEAR(way.place_after(0).x(), 0, 1e-3);
}

TEST(FreeWay, IsMetBadlyBySightingsBesideIt) {
  FreeWay on = way_of(2, 0, 30);
  FreeWay off = on;
  const Vec2 next_m = slowed(2, 0, 31 * kFrame_s);
  on.predict(kFrame_s, kParameters);
  off.predict(kFrame_s, kParameters);
  const double off_m = 5 * std::sqrt(off.place_variance_after(0) + std::pow(0.2e-3, 2));
  const double more =
      off.correct(next_m + Vec2(0, off_m), kParameters) - on.correct(next_m, kParameters);
  EXPECT_NEAR(more, 25, 2);  // five deviations, squared
}

// Minus twice the logarithm of two coordinates' density falls by 4 log 10 where all is ten times as
// exact.
TEST(FreeWay, IsLikelierTheMoreExactItIs) {
  WayParameters coarse = kParameters;
  coarse.sighting_m = 10 * kParameters.sighting_m;
  FreeWay fine_way;
  FreeWay coarse_way;
  fine_way.start({0, 0}, kParameters);
  coarse_way.start({0, 0}, coarse);
  const double more = coarse_way.correct({0, 0}, coarse) - fine_way.correct({0, 0}, kParameters);
  EXPECT_NEAR(more, 4 * std::log(10.0), 1e-5);
}

TEST(FreeWay, KeepsWithinWhatItKnowsUnderNoise) {
  WayParameters noisy = kParameters;
  noisy.sighting_m = 0.0014;
  RandomStream random(1);
  int within = 0;
  for (int run = 0; run < 200; ++run) {
    FreeWay way;
    for (int i = 0; i <= 20; ++i) {
      const double x_m = noisy.sighting_m * random.normal();
      const double y_m = noisy.sighting_m * random.normal();
      const Vec2 seen_m = slowed(3, 3.5, i * kFrame_s) + Vec2(x_m, y_m);
      if (i == 0) {
        way.start(seen_m, noisy);
        continue;
      }
      way.predict(kFrame_s, noisy);
      way.correct(seen_m, noisy);
    }
    const double off_mps = std::abs(way.velocity_mps().x() - (3 - 3.5 * 20 * kFrame_s));
    within += off_mps <= 2 * velocity_off_mps(way) ? 1 : 0;
  }
  EXPECT_GE(within, 180);
}

}  // namespace
}  // namespace autoref::referee
