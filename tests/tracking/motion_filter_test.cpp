#include "tracking/motion_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/random.hpp"

namespace autoref {
namespace {

using Axis = MotionFilter<1>::Axis;

// The textbook's filter in matrices, for one axis.
struct Textbook {
  MotionNoise noise;
  Eigen::Vector2d motion{0, 0};
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();

  void predict(double t) {
    Eigen::Matrix2d even;
    even << 1, t, 0, 1;
    Eigen::Matrix2d unsteady;
    unsteady << t * t * t / 3, t * t / 2, t * t / 2, t;
    motion = even * motion;
    covariance = even * covariance * even.transpose() + noise.unsteady * unsteady;
  }
  void correct(double seen) {
    const Eigen::RowVector2d place(1, 0);
    const double variance =
        (place * covariance * place.transpose()).value() + noise.sighting * noise.sighting;
    const Eigen::Vector2d gain = covariance * place.transpose() / variance;
    motion += gain * (seen - motion(0));
    covariance = (Eigen::Matrix2d::Identity() - gain * place) * covariance;
  }
};

TEST(MotionFilter, DoesAsTheTextbookWithMatrices) {
  const MotionNoise noise{0.002, 0.3, 4.0};
  MotionFilter<1> filter(noise);
  Textbook textbook{noise};
  filter.start(Axis(0.5));
  textbook.motion(0) = 0.5;
  textbook.covariance << 0.002 * 0.002, 0, 0, 16.0;
  RandomStream random(1);
  for (int i = 0; i < 200; ++i) {
    const double duration_s = (1 + i % 3) / 60.0;
    filter.predict(duration_s, Axis(0));
    textbook.predict(duration_s);
    const double seen_m = 0.5 + 0.01 * i + 0.002 * random.normal();
    filter.correct(Axis(seen_m) - filter.position());
    textbook.correct(seen_m);
    ASSERT_NEAR(filter.position().value(), textbook.motion(0), 1e-9) << i;
    ASSERT_NEAR(filter.velocity().value(), textbook.motion(1), 1e-7) << i;
  }
}

// Of a filter whose noise is as it was told, one sighting in 55 is off by more than 8 square
// deviations of two axes (chi-squared: exp(-4)).
TEST(MotionFilter, IsSurprisedAsOftenAsItsNoiseSays) {
  constexpr double kNoise_m = 0.0014;
  constexpr double kUnsteady_m2ps3 = 0.2;
  constexpr double kFrame_s = 1.0 / 60.0;
  MotionFilter<2> filter({kNoise_m, kUnsteady_m2ps3, 3.0});
  RandomStream random(2);
  const auto normal2 = [&random] {
    const double x = random.normal();
    const double y = random.normal();
    return MotionFilter<2>::Axis(x, y);
  };
  MotionFilter<2>::Axis place_m(0, 0);
  MotionFilter<2>::Axis velocity_mps(1, 0.5);
  filter.start(place_m);
  int surprises = 0;
  constexpr int kSightings = 20000;
  for (int i = 0; i < kSightings; ++i) {
    // White acceleration: what a velocity does meanwhile, and its mean over the frame.
    const MotionFilter<2>::Axis jolt_mps = std::sqrt(kUnsteady_m2ps3 * kFrame_s) * normal2();
    const MotionFilter<2>::Axis other_mps = std::sqrt(kUnsteady_m2ps3 * kFrame_s / 12) * normal2();
    place_m += kFrame_s * (velocity_mps + jolt_mps / 2 + other_mps);
    velocity_mps += jolt_mps;
    filter.predict(kFrame_s, MotionFilter<2>::Axis(0, 0));
    const MotionFilter<2>::Axis miss_m = place_m + kNoise_m * normal2() - filter.position();
    surprises += filter.surprise(miss_m) > 8 ? 1 : 0;
    filter.correct(miss_m);
  }
  const double share = static_cast<double>(surprises) / kSightings;
  EXPECT_NEAR(share, std::exp(-4.0), 5 * std::sqrt(std::exp(-4.0) / kSightings));
}

TEST(MotionFilter, LearnsADoubtedVelocityFromOneSighting) {
  MotionFilter<1> filter({0.0001, 0.1, 8.0});
  filter.start(Axis(0));
  for (int i = 0; i < 30; ++i) {
    filter.predict(0.01, Axis(0));
    filter.correct(Axis(0) - filter.position());
  }
  filter.predict(0.01, Axis(0));
  filter.doubt_velocity(0.01);
  filter.correct(Axis(0.05) - filter.position());
  EXPECT_NEAR(filter.velocity().value(), 5.0, 0.01);
}

TEST(MotionFilter, TakesAKnownAccelerationIntoAccount) {
  MotionFilter<1> filter({0.0001, 0.1, 8.0});
  filter.start(Axis(1));
  filter.predict(2.0, Axis(-3));
  EXPECT_DOUBLE_EQ(filter.position().value(), 1.0 - 6.0);
  EXPECT_DOUBLE_EQ(filter.velocity().value(), -6.0);
}

}  // namespace
}  // namespace autoref
