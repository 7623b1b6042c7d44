// How often, how soon and how precisely chips are detected under noise, over thousands of kicks.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/tracking/simulated_kicks.hpp"

namespace autoref::tracking {
namespace {

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
  std::array<double, 5> detected{}, lasting{};
  int called_flying = 0;     // kicks
  int grounded_in_air = 0;   // kicks
  int flying_after_all = 0;  // kicks, more than a frame after landing
  Errors height, position, landing;

  double share_detected(std::size_t mark) const { return detected[mark] / lasting[mark]; }
};

void count_errors(const Kick& kick, const Truth& truth, const ChipEstimate& e, Tally& tally) {
  tally.height.add(std::abs(e.height_m - truth.height_m), e.height_deviation_m);
  tally.position.add((e.position_m - truth.position_m).norm(), e.position_deviation_m);
  tally.landing.add((e.landing_m - kick.landing_m()).norm(), e.landing_deviation_m);
}

void count_kick(const Kick& kick, Vision& vision, Tally& tally) {
  double reported_s = 1e9;
  bool grounded = false;
  bool late = false;
  follow(kick, vision, 1.2, [&](double time_s, const Truth& truth, const ChipEstimate& e) {
    const bool flying = e.flight == BallFlight::kFlying;
    if (flying) reported_s = std::min(reported_s, time_s - kick.time_s);
    if (flying && kick.is_up(time_s)) count_errors(kick, truth, e, tally);
    grounded |= kick.is_up(time_s) && e.flight == BallFlight::kOnGround;
    late |= flying && time_s > kick.landing_s() + 1 / 60.0;
  });
  tally.called_flying += reported_s < 1e9;
  tally.grounded_in_air += grounded;
  tally.flying_after_all += late;
  for (std::size_t i = 0; i < kMarks_s.size(); ++i) {
    const bool lasts = kick.is_up(kick.time_s + kMarks_s[i]);
    tally.lasting[i] += lasts;
    tally.detected[i] += lasts && reported_s <= kMarks_s[i];
  }
}

Tally tally_of(Kick (*any)(RandomStream&), double noise_m) {
  Tally tally;
  Vision vision{noise_m, RandomStream(2)};
  RandomStream chance(1);
  for (int i = 0; i < kKicks; ++i) count_kick(any(chance), vision, tally);
  return tally;
}

// The values stated in chip_flight.hpp.
struct Figures {
  const char* name = "";
  double noise_m = 0;
  std::array<double, 5> detected{};  // fractions detected by the times kMarks_s
  double height_rms_m = 0;
  double height_median_m = 0;
  double landing_rms_m = 0;
  double landing_median_m = 0;
};

class ChipFlightInNoise : public testing::TestWithParam<Figures> {};

// The mark, by index, at which the fraction of detected chips differs by more than 0.02; none: -1.
int first_differing_mark(const Tally& tally, const std::array<double, 5>& detected) {
  for (std::size_t i = 0; i < kMarks_s.size(); ++i) {
    if (!(std::abs(tally.share_detected(i) - detected[i]) <= 0.02)) return static_cast<int>(i);
  }
  return -1;
}

TEST_P(ChipFlightInNoise, DetectsChipsAsSoonAsStated) {
  const Tally tally = tally_of(chip_inside_the_field, GetParam().noise_m);
  EXPECT_EQ(first_differing_mark(tally, GetParam().detected), -1);
}

TEST_P(ChipFlightInNoise, RarelyDetectsAFlightForAStraightKick) {
  EXPECT_LE(tally_of(straight_kick, GetParam().noise_m).called_flying, 0.001 * kKicks);
}

TEST_P(ChipFlightInNoise, RarelyReportsAFlyingBallOnTheGround) {
  EXPECT_LE(tally_of(chip_inside_the_field, GetParam().noise_m).grounded_in_air, 0.001 * kKicks);
}

TEST_P(ChipFlightInNoise, IsAsPreciseAsStated) {
  Tally tally = tally_of(chip_inside_the_field, GetParam().noise_m);
  EXPECT_NEAR(tally.height.rms(), GetParam().height_rms_m, 2_mm);
  EXPECT_NEAR(tally.height.median(), GetParam().height_median_m, 1_mm);
  EXPECT_NEAR(tally.landing.rms(), GetParam().landing_rms_m, 10_mm);
  EXPECT_NEAR(tally.landing.median(), GetParam().landing_median_m, 2_mm);
}

TEST_P(ChipFlightInNoise, ReportsConsistentDeviations) {
  const Tally tally = tally_of(chip_inside_the_field, GetParam().noise_m);
  EXPECT_GE(tally.height.covered(), 0.95);
  EXPECT_GE(tally.position.covered(), 0.95);
  EXPECT_GE(tally.landing.covered(), 0.95);
}

TEST_P(ChipFlightInNoise, RarelyReportsAFlightAfterTheLanding) {
  EXPECT_LE(tally_of(chip_inside_the_field, GetParam().noise_m).flying_after_all, 0.01 * kKicks);
}

INSTANTIATE_TEST_SUITE_P(Cameras, ChipFlightInNoise,
                         testing::Values(Figures{.name = "none",
                                                 .detected = {0.39, 0.96, 0.99, 1, 1},
                                                 .height_rms_m = 4_mm,
                                                 .height_median_m = 0.3_mm,
                                                 .landing_rms_m = 47_mm,
                                                 .landing_median_m = 0.3_mm},
                                         Figures{.name = "friendly",
                                                 .noise_m = 0.4_mm,
                                                 .detected = {0.08, 0.90, 0.97, 0.99, 1},
                                                 .height_rms_m = 16_mm,
                                                 .height_median_m = 3_mm,
                                                 .landing_rms_m = 110_mm,
                                                 .landing_median_m = 5_mm},
                                         Figures{.name = "rc2021",
                                                 .noise_m = 1_mm,
                                                 .detected = {0.02, 0.64, 0.92, 0.97, 1},
                                                 .height_rms_m = 26_mm,
                                                 .height_median_m = 7_mm,
                                                 .landing_rms_m = 130_mm,
                                                 .landing_median_m = 11_mm},
                                         Figures{.name = "realistic",
                                                 .noise_m = 1.4_mm,
                                                 .detected = {0.01, 0.44, 0.88, 0.95, 1},
                                                 .height_rms_m = 32_mm,
                                                 .height_median_m = 9_mm,
                                                 .landing_rms_m = 137_mm,
                                                 .landing_median_m = 14_mm}),
                         [](const auto& row) { return row.param.name; });

// Straight towards or away from the camera, where a flight is hardest to distinguish from a roll.
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

TEST(ChipFlightTowardsTheCamera, TakesLongerToDetectButStaysConsistent) {
  const Tally tally = tally_of(chip_along_the_ray, 1.4_mm);
  EXPECT_NEAR(tally.share_detected(2), 0.65, 0.03);
  EXPECT_LE(tally.grounded_in_air, 0.003 * kKicks);
  EXPECT_GE(tally.height.covered(), 0.95);
  EXPECT_GE(tally.landing.covered(), 0.95);
}

TEST(ChipFlightTowardsTheCamera, RarelyDetectsAFlightForAStraightKick) {
  EXPECT_LE(tally_of(straight_kick_along_the_ray, 1.4_mm).called_flying, 0.003 * kKicks);
}

}  // namespace
}  // namespace autoref::tracking
