#include "tracking/motion_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/random.hpp"

namespace autoref::tracking {
namespace {

using Axis = MotionFilter<1>::Axis;

// The textbook Kalman filter in matrix form, for one axis.
struct Textbook {
  MotionNoise noise;
  Eigen::Vector2d motion{0, 0};
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();

  void predict(double t) {
    Eigen::Matrix2d even;
    even << 1, t, 0, 1;
    Eigen::Matrix2d process_noise_density;
    process_noise_density << t * t * t / 3, t * t / 2, t * t / 2, t;
    motion = even * motion;
    covariance =
        even * covariance * even.transpose() + noise.process_noise_density * process_noise_density;
  }
  void correct(double seen) {
    const Eigen::RowVector2d position(1, 0);
    const double variance =
        (position * covariance * position.transpose()).value() + noise.detection * noise.detection;
    const Eigen::Vector2d gain = covariance * position.transpose() / variance;
    motion += gain * (seen - motion(0));
    covariance = (Eigen::Matrix2d::Identity() - gain * position) * covariance;
  }
};

TEST(MotionFilter, MatchesTheTextbookInMatrixForm) {
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

// With a correct noise model, one detection in 55 has a normalised innovation squared above 8
// (chi-square with two degrees of freedom: exp(-4)).
TEST(MotionFilter, HasConsistentInnovations) {
  constexpr double kNoise_m = 0.0014;
  constexpr double kProcessNoise_m2ps3 = 0.2;
  constexpr double kFrame_s = 1.0 / 60.0;
  MotionFilter<2> filter({kNoise_m, kProcessNoise_m2ps3, 3.0});
  RandomStream random(2);
  const auto normal2 = [&random] {
    const double x = random.normal();
    const double y = random.normal();
    return MotionFilter<2>::Axis(x, y);
  };
  MotionFilter<2>::Axis position_m(0, 0);
  MotionFilter<2>::Axis velocity_mps(1, 0.5);
  filter.start(position_m);
  int innovations = 0;
  constexpr int kDetections = 20000;
  for (int i = 0; i < kDetections; ++i) {
    // White acceleration: the change of velocity in one frame, and its mean over the frame.
    const MotionFilter<2>::Axis jolt_mps = std::sqrt(kProcessNoise_m2ps3 * kFrame_s) * normal2();
    const MotionFilter<2>::Axis other_mps =
        std::sqrt(kProcessNoise_m2ps3 * kFrame_s / 12) * normal2();
    position_m += kFrame_s * (velocity_mps + jolt_mps / 2 + other_mps);
    velocity_mps += jolt_mps;
    filter.predict(kFrame_s, MotionFilter<2>::Axis(0, 0));
    const MotionFilter<2>::Axis innovation_m =
        position_m + kNoise_m * normal2() - filter.position();
    innovations += filter.normalised_innovation_squared(innovation_m) > 8 ? 1 : 0;
    filter.correct(innovation_m);
  }
  const double share = static_cast<double>(innovations) / kDetections;
  EXPECT_NEAR(share, std::exp(-4.0), 5 * std::sqrt(std::exp(-4.0) / kDetections));
}

// A filter of something at rest at 0 that has been detected 30 times.
MotionFilter<1> filter_at_rest() {
  MotionFilter<1> filter({0.0001, 0.1, 8.0});
  filter.start(Axis(0));
  for (int i = 0; i < 30; ++i) {
    filter.predict(0.01, Axis(0));
    filter.correct(Axis(0) - filter.position());
  }
  return filter;
}

TEST(MotionFilter, LearnsTheVelocityFromOneDetectionAfterInflation) {
  MotionFilter<1> filter = filter_at_rest();
  filter.predict(0.01, Axis(0));
  filter.inflate_velocity_covariance(0.01);
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
}  // namespace autoref::tracking
