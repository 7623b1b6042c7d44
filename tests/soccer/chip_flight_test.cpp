#include "soccer/chip_flight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "soccer/random.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref {
namespace {

constexpr double kCameraHeight_m = 4_m;

// How balls slow down and hop in the league's simulators.
struct BallModel {
  double slide_mps2, roll_mps2, rolls_below, along_first, along_later, upwards;
};
constexpr std::array<BallModel, 4> kModels = {{{3.4, 0.30, 0.67, 0.75, 0.95, 0.5},
                                               {3.92, 0.35, 0.69, 0.715, 1.0, 0.566},
                                               {3.0, 0.26, 0.667, 0.8, 0.85, 0.47},
                                               {10.3, 0.70, 0.70, 0.59, 0.95, 0.49}}};

struct Kick {
  double time_s = 0;
  Vec2 from_m{0, 0};
  Vec2 along{1, 0};
  double speed_mps = 0;  // along the carpet
  double rise_mps = 0;   // 0: a straight kick
  BallModel model = kModels[0];

  double landing_s() const { return time_s + 2 * rise_mps / kGravity_mps2; }
  Vec2 landing_m() const { return from_m + along * speed_mps * (landing_s() - time_s); }
  bool is_up(double at_s) const { return at_s > time_s && at_s < landing_s(); }
};

struct Truth {
  Vec2 place_m{0, 0};
  double height_m = 0;
};

double rolled_m(const Kick& kick, double t) {
  const double v = kick.speed_mps;
  const BallModel& m = kick.model;
  const double slides_s = std::min(t, (1 - m.rolls_below) * v / m.slide_mps2);
  const double rolls_s = std::min(t - slides_s, m.rolls_below * v / m.roll_mps2);
  return v * slides_s - m.slide_mps2 / 2 * slides_s * slides_s + m.rolls_below * v * rolls_s -
         m.roll_mps2 / 2 * rolls_s * rolls_s;
}

// A flight, hops, and a ball that then goes on evenly.
Truth flight_at(const Kick& kick, double t) {
  double along_m = 0;
  double speed = kick.speed_mps;
  double rise = kick.rise_mps;
  for (bool first = true; rise * rise > 2 * kGravity_mps2 * 10_mm; first = false) {
    const double hop_s = 2 * rise / kGravity_mps2;
    const double up_s = std::min(t, hop_s);
    along_m += speed * up_s;
    if (t < hop_s) {
      return {kick.from_m + kick.along * along_m, rise * t - kGravity_mps2 / 2 * t * t};
    }
    t -= hop_s;
    speed *= first ? kick.model.along_first : kick.model.along_later;
    rise *= kick.model.upwards;
  }
  return {kick.from_m + kick.along * (along_m + speed * t), 0};
}

Truth truth_at(const Kick& kick, double time_s) {
  const double t = std::max(time_s - kick.time_s, 0.0);
  if (kick.rise_mps > 0) return flight_at(kick, t);
  return {kick.from_m + kick.along * rolled_m(kick, t), 0};
}

// Seen by the camera over the ball's quarter of a field of 9 x 6 m.
BallSighting seen(const Truth& truth, double time_s) {
  const Vec2 camera(truth.place_m.x() < 0 ? -2.25 : 2.25, truth.place_m.y() < 0 ? -1.5 : 1.5);
  const double stretch = kCameraHeight_m / (kCameraHeight_m - truth.height_m);
  return {time_s, camera + (truth.place_m - camera) * stretch, camera, kCameraHeight_m};
}

struct Vision {
  double noise_m;
  RandomStream chance;

  BallSighting see(const Truth& truth, double time_s) {
    BallSighting sighting = seen(truth, time_s);
    const double x = chance.normal();
    const double y = chance.normal();
    sighting.reported_m += noise_m * Vec2(x, y);
    return sighting;
  }
  bool misses() { return chance.uniform() < 0.05; }
};

Kick any_kick(RandomStream& chance) {
  Kick kick;
  kick.model = kModels[static_cast<std::size_t>(4 * chance.uniform())];
  kick.time_s = (1 + chance.uniform()) / 60;
  kick.from_m.x() = 9 * chance.uniform() - 4.5;
  kick.from_m.y() = 6 * chance.uniform() - 3;
  kick.along = heading_of(2 * kPi * chance.uniform());
  return kick;
}

Kick straight_kick(RandomStream& chance) {
  Kick kick = any_kick(chance);
  kick.speed_mps = 1 + 5.5 * chance.uniform();
  return kick;
}

Kick chip_inside_the_field(RandomStream& chance) {
  for (;;) {
    Kick kick = any_kick(chance);
    kick.speed_mps = (2 + 3.5 * chance.uniform()) / std::sqrt(2.0);
    kick.rise_mps = kick.speed_mps;
    const Vec2 end_m = kick.landing_m();
    if (std::abs(end_m.x()) < 4.5 && std::abs(end_m.y()) < 3) return kick;
  }
}

// Feeds one kick to an estimator, at 60 Hz; calls `look(time, truth, estimate)` at each sighting.
template <class Look>
void follow(const Kick& kick, Vision& vision, double until_s, Look look) {
  ChipFlight flight(vision.noise_m);
  BallSighting before = vision.see(truth_at(kick, 0), 0);
  for (int n = 1; n < 60 * until_s; ++n) {
    const double time_s = n / 60.0;
    const Truth truth = truth_at(kick, time_s);
    const BallSighting sighting = vision.see(truth, time_s);
    if (vision.misses()) continue;
    if (time_s > kick.time_s && before.time_s <= kick.time_s) {
      flight.begin({(before.time_s + time_s) / 2, (time_s - before.time_s) / std::sqrt(12.0),
                    before.reported_m, vision.noise_m});
    }
    before = sighting;
    if (time_s > kick.time_s) look(time_s, truth, flight.add(sighting));
  }
}

struct Errors {
  std::vector<double> sizes;
  double squares = 0;
  int within_two_deviations = 0;

  void add(double size, double deviation) {
    sizes.push_back(size);
    squares += size * size;
    within_two_deviations += size < 2 * deviation;
  }
  double count() const { return static_cast<double>(sizes.size()); }
  double rms() const { return std::sqrt(squares / count()); }
  double covered() const { return within_two_deviations / count(); }
  double median() {
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
  }
};

constexpr std::array<double, 5> kMarks_s = {0.05, 0.1, 0.15, 0.2, 0.3};
constexpr int kKicks = 3000;

struct Tally {
  std::array<double, 5> told{}, lasting{};
  int called_flying = 0;     // kicks
  int grounded_in_air = 0;   // kicks
  int flying_after_all = 0;  // kicks, more than a frame after the landing
  Errors height, place, landing;

  double share_told(std::size_t mark) const { return told[mark] / lasting[mark]; }
};

void count_errors(const Kick& kick, const Truth& truth, const ChipEstimate& e, Tally& tally) {
  tally.height.add(std::abs(e.height_m - truth.height_m), e.height_deviation_m);
  tally.place.add((e.position_m - truth.place_m).norm(), e.position_deviation_m);
  tally.landing.add((e.landing_m - kick.landing_m()).norm(), e.landing_deviation_m);
}

void count_kick(const Kick& kick, Vision& vision, Tally& tally) {
  double told_s = 1e9;
  bool grounded = false;
  bool late = false;
  follow(kick, vision, 1.2, [&](double time_s, const Truth& truth, const ChipEstimate& e) {
    const bool flying = e.flight == BallFlight::kFlying;
    if (flying) told_s = std::min(told_s, time_s - kick.time_s);
    if (flying && kick.is_up(time_s)) count_errors(kick, truth, e, tally);
    grounded |= kick.is_up(time_s) && e.flight == BallFlight::kOnGround;
    late |= flying && time_s > kick.landing_s() + 1 / 60.0;
  });
  tally.called_flying += told_s < 1e9;
  tally.grounded_in_air += grounded;
  tally.flying_after_all += late;
  for (std::size_t i = 0; i < kMarks_s.size(); ++i) {
    const bool lasts = kick.is_up(kick.time_s + kMarks_s[i]);
    tally.lasting[i] += lasts;
    tally.told[i] += lasts && told_s <= kMarks_s[i];
  }
}

Tally tally_of(Kick (*any)(RandomStream&), double noise_m) {
  Tally tally;
  Vision vision{noise_m, RandomStream(2)};
  RandomStream chance(1);
  for (int i = 0; i < kKicks; ++i) count_kick(any(chance), vision, tally);
  return tally;
}

// What the header states.
struct Figures {
  const char* name;
  double noise_m;
  std::array<double, 5> told;  // shares, at kMarks_s
  double height_rms_m, height_median_m, landing_rms_m, landing_median_m;
};

class ChipFlightInNoise : public testing::TestWithParam<Figures> {};

TEST_P(ChipFlightInNoise, TellsChipsAsSoonAsStated) {
  const Tally tally = tally_of(chip_inside_the_field, GetParam().noise_m);
  for (std::size_t i = 0; i < kMarks_s.size(); ++i) {
    EXPECT_NEAR(tally.share_told(i), GetParam().told[i], 0.02) << kMarks_s[i];
  }
}

TEST_P(ChipFlightInNoise, CallsHardlyAnyStraightKickFlying) {
  EXPECT_LE(tally_of(straight_kick, GetParam().noise_m).called_flying, 0.001 * kKicks);
}

TEST_P(ChipFlightInNoise, HardlyEverPutsAFlyingBallOnTheGround) {
  EXPECT_LE(tally_of(chip_inside_the_field, GetParam().noise_m).grounded_in_air, 0.001 * kKicks);
}

TEST_P(ChipFlightInNoise, IsAsPreciseAsStated) {
  Tally tally = tally_of(chip_inside_the_field, GetParam().noise_m);
  EXPECT_NEAR(tally.height.rms(), GetParam().height_rms_m, 2_mm);
  EXPECT_NEAR(tally.height.median(), GetParam().height_median_m, 1_mm);
  EXPECT_NEAR(tally.landing.rms(), GetParam().landing_rms_m, 10_mm);
  EXPECT_NEAR(tally.landing.median(), GetParam().landing_median_m, 2_mm);
}

TEST_P(ChipFlightInNoise, StatesHonestDeviations) {
  const Tally tally = tally_of(chip_inside_the_field, GetParam().noise_m);
  EXPECT_GE(tally.height.covered(), 0.95);
  EXPECT_GE(tally.place.covered(), 0.95);
  EXPECT_GE(tally.landing.covered(), 0.95);
}

TEST_P(ChipFlightInNoise, HardlyEverFliesOnAfterTheLanding) {
  EXPECT_LE(tally_of(chip_inside_the_field, GetParam().noise_m).flying_after_all, 0.01 * kKicks);
}

INSTANTIATE_TEST_SUITE_P(
    Cameras, ChipFlightInNoise,
    testing::Values(
        Figures{"none", 0, {0.39, 0.96, 0.99, 1, 1}, 4_mm, 0.3_mm, 47_mm, 0.3_mm},
        Figures{"friendly", 0.4_mm, {0.08, 0.90, 0.97, 0.99, 1}, 16_mm, 3_mm, 110_mm, 5_mm},
        Figures{"rc2021", 1_mm, {0.02, 0.64, 0.92, 0.97, 1}, 26_mm, 7_mm, 130_mm, 11_mm},
        Figures{"realistic", 1.4_mm, {0.01, 0.44, 0.88, 0.95, 1}, 32_mm, 9_mm, 137_mm, 14_mm}),
    [](const auto& row) { return row.param.name; });

// Straight to or from the camera, where a flight looks most like a way along the carpet.
void aim_at_camera(Kick& kick, RandomStream& chance) {
  const Vec2 camera = seen({kick.from_m, 0}, 0).camera_m;
  const double sign = chance.uniform() < 0.5 ? 1 : -1;
  kick.along = sign * direction_of(camera - kick.from_m, Vec2(1, 0));
}

Kick straight_kick_along_the_ray(RandomStream& chance) {
  Kick kick = straight_kick(chance);
  aim_at_camera(kick, chance);
  return kick;
}

Kick chip_along_the_ray(RandomStream& chance) {
  Kick kick = chip_inside_the_field(chance);
  aim_at_camera(kick, chance);
  return kick;
}

TEST(ChipFlightTowardsTheCamera, TakesLongerToBeToldAndIsStillHonest) {
  const Tally tally = tally_of(chip_along_the_ray, 1.4_mm);
  EXPECT_NEAR(tally.share_told(2), 0.65, 0.03);
  EXPECT_LE(tally.grounded_in_air, 0.003 * kKicks);
  EXPECT_GE(tally.height.covered(), 0.95);
  EXPECT_GE(tally.landing.covered(), 0.95);
}

TEST(ChipFlightTowardsTheCamera, CallsHardlyAnyStraightKickFlying) {
  EXPECT_LE(tally_of(straight_kick_along_the_ray, 1.4_mm).called_flying, 0.003 * kKicks);
}

// The chip of the closed forms: 5 m/s at 45 degrees first lands v²/g = 2.548 m away.
Kick chip_along(const Vec2& from_m, const Vec2& along) {
  return {0.01, from_m, along, 5 / std::sqrt(2.0), 5 / std::sqrt(2.0)};
}

// The estimate at `time_s`, by sightings without noise that are never missing.
ChipEstimate clean_estimate(const Kick& kick, double time_s) {
  ChipFlight flight(0);
  flight.begin({kick.time_s, 5_mm, kick.from_m, 0});
  for (int n = 1; n / 60.0 <= time_s; ++n) flight.add(seen(truth_at(kick, n / 60.0), n / 60.0));
  return flight.estimate();
}

TEST(ChipFlight, FindsTheClosedFormsOfAFlight) {
  const ChipEstimate e = clean_estimate(chip_along({0.5, 0.5}, {0.8, 0.6}), 0.35);
  EXPECT_EQ(e.flight, BallFlight::kFlying);
  EXPECT_NEAR(e.height_m, 3.5355 * 0.34 - 4.905 * 0.34 * 0.34, 2_mm);
  EXPECT_NEAR(e.vertical_speed_mps, 3.5355 - 9.81 * 0.34, 0.01);
  EXPECT_NEAR(e.landing_s, 0.01 + 0.7208, 0.002);
  EXPECT_NEAR((e.landing_m - Vec2(0.5, 0.5)).norm(), 2.548, 5_mm);
}

TEST(ChipFlight, GoesOnWhereAnotherCameraTakesOver) {
  const Kick kick = chip_along({-0.8, 0.7}, {1, 0});  // over the middle line after 0.23 s
  const ChipEstimate e = clean_estimate(kick, 0.5);
  EXPECT_EQ(e.flight, BallFlight::kFlying);
  EXPECT_NEAR(e.height_m, 3.5355 * 0.49 - 4.905 * 0.49 * 0.49, 2_mm);
}

TEST(ChipFlight, PutsAStraightKickOnTheGroundForGood) {
  Kick kick = chip_along({0.5, 0.5}, {0.8, 0.6});
  kick.rise_mps = 0;
  EXPECT_EQ(clean_estimate(kick, 0.2).flight, BallFlight::kOnGround);
  EXPECT_EQ(clean_estimate(kick, 1.0).flight, BallFlight::kOnGround);
}

TEST(ChipFlight, IsUnknownWhileTheBallHopsThenOnTheGround) {
  const Kick kick = chip_along({-2, 0.5}, {1, 0});
  EXPECT_EQ(clean_estimate(kick, 0.80).flight, BallFlight::kUnknown);
  EXPECT_EQ(clean_estimate(kick, 1.35).flight, BallFlight::kUnknown);
  EXPECT_EQ(clean_estimate(kick, 1.75).flight, BallFlight::kOnGround);
}

TEST(ChipFlight, IsUnknownBeforeAKickAndAfterTheNext) {
  ChipFlight flight(1.4_mm);
  EXPECT_EQ(flight.add({0, {1, 1}, {2, 1}, 4}).flight, BallFlight::kUnknown);
  for (int n = 1; n < 120; ++n) flight.add({n / 60.0, {n / 60.0, 1}, {2, 1}, 4});
  EXPECT_EQ(flight.estimate().flight, BallFlight::kUnknown);
  flight.begin({2, 5_ms, {2, 1}, 1_mm});
  EXPECT_EQ(flight.estimate().flight, BallFlight::kUnknown);
}

// A robot in the way: the ball turns aside and falls.
TEST(ChipFlight, GivesUpWhereTheBallIsHitInTheAir) {
  const Kick kick = chip_along({-2, 0.5}, {1, 0});
  ChipFlight flight(1_mm);
  flight.begin({kick.time_s, 5_ms, kick.from_m, 1_mm});
  for (int n = 1; n <= 15; ++n) flight.add(seen(truth_at(kick, n / 60.0), n / 60.0));
  ASSERT_EQ(flight.estimate().flight, BallFlight::kFlying);
  const Truth hit = truth_at(kick, 0.25);
  for (int n = 16; n <= 18; ++n) {
    flight.add(seen({hit.place_m + Vec2(0, (n - 15) / 60.0), hit.height_m}, n / 60.0));
  }
  EXPECT_EQ(flight.estimate().flight, BallFlight::kUnknown);
  const BallSighting later = seen({hit.place_m, 0}, 2.0);  // when the hops would be over
  EXPECT_EQ(flight.add(later).flight, BallFlight::kUnknown);
}

// After three sightings of a kick, a robot turns the ball aside, and the next one stops it.
TEST(ChipFlight, BelievesNeitherOfTwoBadFitsUntilNothingCanFly) {
  ChipFlight flight(1.4_mm);
  flight.begin({0, 5_ms, {0.5, 0.5}, 1.4_mm});
  for (int n = 1; n <= 110; ++n) {
    const Vec2 way_m(0.08 * std::min(n, 3), 0.04 * std::clamp(n - 3, 0, 10));
    flight.add(seen({Vec2(0.5, 0.5) + way_m, 0}, n / 60.0));
    EXPECT_NE(flight.estimate().flight, BallFlight::kFlying) << n;
    EXPECT_NE(flight.estimate().flight, BallFlight::kOnGround) << n;
  }
  for (int n = 111; n <= 130; ++n) flight.add(seen({{0.74, 0.9}, 0}, n / 60.0));
  EXPECT_EQ(flight.estimate().flight, BallFlight::kOnGround);
}

TEST(ChipFlight, SeesTheTurnedFlightTurned) {
  const Kick kick = chip_along({0.5, 0.5}, {0.8, 0.6});
  const Kick turned = chip_along({-0.5, -0.5}, {-0.8, -0.6});
  const ChipEstimate a = clean_estimate(kick, 0.3);
  const ChipEstimate b = clean_estimate(turned, 0.3);
  EXPECT_EQ(a.position_m, -b.position_m);
  EXPECT_EQ(a.height_m, b.height_m);
  EXPECT_EQ(a.landing_m, -b.landing_m);
}

}  // namespace
}  // namespace autoref
