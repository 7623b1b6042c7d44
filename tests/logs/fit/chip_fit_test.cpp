#include "logs/fit/chip_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/random.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kChipFrame_s = 1 / 60.0;
constexpr int kFramesBeforeChip = 20;  // a kick
constexpr int kFramesAfterChip = 120;
const CameraPosition kChipCamera{{0.5, 0.8}, 4};
const Vec2 kChipRest_m(-2, -0.4);

// A ball in small steps, as simple as possible.
struct BallInSteps {
  double along_m = 0;
  double speed_mps = 0;
  double height_m = 0;
  double rise_mps = 0;
  double first_xy = 0.7;
  double first_z = 0.5;
  double later_xy = 0.9;
  bool has_landed = false;
  double slides_above_mps = 0;  // a ball that flies rolls after landing

  void advance() {
    constexpr double kStep_s = 1e-5;
    for (int step = 0; step < std::lround(kChipFrame_s / kStep_s); ++step) {
      along_m += speed_mps * kStep_s;
      if (height_m == 0 && rise_mps == 0) {
        speed_mps -= (speed_mps > slides_above_mps ? 3.4 : 0.3) * kStep_s;
        continue;
      }
      height_m += rise_mps * kStep_s;
      rise_mps -= kGravity_mps2 * kStep_s;
      if (height_m <= 0) land();
    }
  }

  void land() {
    height_m = 0;
    rise_mps *= -first_z;
    speed_mps *= has_landed ? later_xy : first_xy;
    has_landed = true;
    if (rise_mps < 0.45) rise_mps = 0;  // 10 mm
    slides_above_mps = speed_mps;
  }
};

class KickedMotion {
 public:
  explicit KickedMotion(double noise_m = 1_mm, const Vec2& rest_m = kChipRest_m) : rest_m_(rest_m) {
    motion_.interval_s = kChipFrame_s;
    motion_.ball_noise_m = noise_m;
    motion_.cameras[0] = kChipCamera;
  }

  // The ball lies at a robot for a while and is then kicked into the direction `angle_rad`.
  void kick(BallInSteps ball, double angle_rad) {
    for (int i = 0; i < kFramesBeforeChip; ++i) add_frame(rest_m_, 0, true);
    for (int i = 0; i < kFramesAfterChip; ++i) {
      ball.advance();
      add_frame(rest_m_ + ball.along_m * heading_of(angle_rad), ball.height_m,
                ball.along_m < 30_mm);
    }
  }

  void chip(double speed_mps, double elevation_deg, double angle_rad) {
    const Vec2 direction = heading_of(to_radians(elevation_deg));
    BallInSteps ball;
    ball.speed_mps = speed_mps * direction.x();
    ball.rise_mps = speed_mps * direction.y();
    kick(ball, angle_rad);
  }

  // Chips of different speeds, directions and elevations.
  void chip_often(int chips, double elevation_deg, double spread_deg) {
    for (int i = 0; i < chips; ++i)
      chip(4 + 0.15 * i, elevation_deg + spread_deg * random_.normal(), 0.2 - 0.07 * i);
  }

  RecordedMotion& motion() { return motion_; }

 private:
  void add_frame(const Vec2& position_m, double height_m, bool is_touched) {
    const double time_s = kChipFrame_s * static_cast<double>(motion_.frames());
    const double below_m = kChipCamera.height_m - kBallRadius_m;
    BallSight sight;
    sight.position_m = kChipCamera.position_m +
                       (position_m - kChipCamera.position_m) * (below_m / (below_m - height_m)) +
                       motion_.ball_noise_m * Vec2(random_.normal(), random_.normal());
    sight.time_s = time_s;
    sight.is_seen = true;
    motion_.times_s.push_back(time_s);
    motion_.ball.push_back(sight);
    motion_.is_running.push_back(true);
    motion_.nearest_m.push_back(is_touched ? 0.1 : 1.0);
    motion_.nearest_robot.push_back(0);
  }

  Vec2 rest_m_;
  RecordedMotion motion_;
  RandomStream random_{5};
};

ChipFit chip_fit_of(KickedMotion& kicked) {
  ChipFit fit;
  fit.add(kicked.motion());
  return fit;
}

void expect_near_in_chips(const Estimate& estimate, double truth, double tolerance) {
  ASSERT_TRUE(estimate.number.has_value());
  EXPECT_NEAR(estimate.number->value, truth, tolerance);
  EXPECT_LE(estimate.number->low, truth);
  EXPECT_GE(estimate.number->high, truth);
}

TEST(ChipFit, EstimatesSpeedKeptAtLandings) {
  KickedMotion kicked;
  kicked.chip_often(6, 45, 0);
  const ChipFit fit = chip_fit_of(kicked);
  EXPECT_EQ(fit.hop_first_xy().episodes, 6);
  expect_near_in_chips(fit.hop_first_xy(), 0.7, 0.01);
  expect_near_in_chips(fit.hop_first_z(), 0.5, 0.02);
  expect_near_in_chips(fit.hop_later_xy(), 0.9, 0.03);
}

TEST(ChipFit, EstimatesElevationAndItsSpread) {
  KickedMotion kicked;
  kicked.chip_often(12, 50, 5);
  const ChipFit fit = chip_fit_of(kicked);
  expect_near_in_chips(fit.chip_angle_deg(), 50, 4);
  expect_near_in_chips(fit.chip_angle_noise_deg(), 5, 2.5);
  EXPECT_GT(fit.chip_angle_noise_deg().number->low, 1);
}

TEST(ChipFit, DoesNotReportErrorsOfMeasurementAsSpread) {
  KickedMotion kicked;
  kicked.chip_often(10, 45, 0);
  const Estimate noise_deg = chip_fit_of(kicked).chip_angle_noise_deg();
  ASSERT_TRUE(noise_deg.number.has_value());
  EXPECT_LT(noise_deg.number->value, 0.3);
  EXPECT_EQ(noise_deg.number->low, 0);
}

TEST(ChipFit, TrustsSingleChipLittleAndTakesNoAngleFromIt) {
  KickedMotion kicked;
  kicked.chip_often(1, 45, 0);
  const ChipFit fit = chip_fit_of(kicked);
  const Estimate first_xy = fit.hop_first_xy();
  ASSERT_TRUE(first_xy.number.has_value());
  EXPECT_NEAR(first_xy.number->high - first_xy.number->value, 0.15 * 0.7, 0.02);
  EXPECT_FALSE(fit.chip_angle_deg().number.has_value());
  EXPECT_FALSE(fit.chip_angle_noise_deg().number.has_value());
}

// Under the camera, noise can look like a flight.
TEST(ChipFit, FindsNoChipAmongKicksOnTheCarpet) {
  KickedMotion kicked(2_mm, {0.3, 0.5});
  for (int i = 0; i < 100; ++i) {
    BallInSteps ball;
    ball.speed_mps = 1 + 0.03 * i;
    ball.slides_above_mps = (i % 3 == 0 ? 0.67 : 0.98) * ball.speed_mps;
    kicked.kick(ball, to_radians(15) * (i % 24));
  }
  EXPECT_EQ(chip_fit_of(kicked).hop_first_xy().episodes, 0);
}

TEST(ChipFit, IgnoresBounceOfBallThatStopsAtItsLanding) {
  KickedMotion kicked;
  BallInSteps ball;
  ball.speed_mps = ball.rise_mps = 3;
  ball.first_xy = 0.05;
  kicked.kick(ball, 0);
  EXPECT_EQ(chip_fit_of(kicked).hop_first_xy().episodes, 0);
}

TEST(ChipFit, NeedsCalibratedCamera) {
  KickedMotion kicked;
  kicked.chip_often(2, 45, 0);
  EXPECT_EQ(chip_fit_of(kicked).hop_first_xy().episodes, 2);
  kicked.motion().cameras.clear();
  EXPECT_EQ(chip_fit_of(kicked).hop_first_xy().episodes, 0);
}

}  // namespace
}  // namespace autoref::logs
