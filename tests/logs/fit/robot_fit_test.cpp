#include "logs/fit/robot_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

constexpr double kShuttleRate_hz = 60;
constexpr double kShuttleNoise_m = 0.001;
constexpr double kShuttleNoise_rad = 0.004;

// What a robot reaches that drives to and fro along x, and turns to and fro.
struct Limits {
  double speed_mps = 2.0;
  double acceleration_mps2 = 2.5;
  double braking_mps2 = 4.0;
  double angular_speed_radps = 6.0;
  double angular_acceleration_radps2 = 30.0;
};

// A distance or an angle that grows and shrinks again, from rest to rest, at full speed for 0.5 s.
class Shuttle {
 public:
  Shuttle(double speed, double acceleration, double braking)
      : speed_(speed), acceleration_(acceleration), braking_(braking) {}

  double at(double time_s) const {
    const double round_s = 2 * leg_s();
    const double in_round_s = std::fmod(time_s, round_s);
    return in_round_s < leg_s() ? out(in_round_s) : out(leg_s()) - out(in_round_s - leg_s());
  }

 private:
  double leg_s() const { return speed_ / acceleration_ + kCruise_s + speed_ / braking_; }
  double out(double time_s) const {
    const double gain_s = std::min(time_s, speed_ / acceleration_);
    const double cruise_s = std::clamp(time_s - gain_s, 0.0, kCruise_s);
    const double brake_s = std::max(0.0, time_s - gain_s - cruise_s);
    return acceleration_ * gain_s * gain_s / 2 + speed_ * (cruise_s + brake_s) -
           braking_ * brake_s * brake_s / 2;
  }

  static constexpr double kCruise_s = 0.5;
  double speed_;
  double acceleration_;
  double braking_;
};

RobotMotion shuttling(const Limits& limits, RobotId id, const std::vector<double>& times_s,
                      double y_m) {
  RandomStream random(static_cast<std::uint64_t>(id.number));
  const Shuttle drive(limits.speed_mps, limits.acceleration_mps2, limits.braking_mps2);
  const Shuttle turn(limits.angular_speed_radps, limits.angular_acceleration_radps2,
                     limits.angular_acceleration_radps2);
  RobotMotion robot{id, {}};
  for (const double time_s : times_s) {
    RobotSight sight;
    sight.position_m = {drive.at(time_s) + kShuttleNoise_m * random.normal(),
                        y_m + kShuttleNoise_m * random.normal()};
    sight.heading_rad = turn.at(time_s) + kShuttleNoise_rad * random.normal();
    sight.is_known = true;
    sight.is_seen = random.uniform() > 0.02;
    robot.sights.push_back(sight);
  }
  return robot;
}

// Yellow 1, which shuttles, and blue 2, which does so at half of its speeds.
RecordedMotion shuttles(double duration_s) {
  RecordedMotion motion;
  motion.interval_s = 1 / kShuttleRate_hz;
  const int frames = static_cast<int>(duration_s * kShuttleRate_hz);
  for (int i = 0; i < frames; ++i) motion.times_s.push_back(i / kShuttleRate_hz);
  motion.robots.push_back(shuttling({}, {Side::kWest, 1}, motion.times_s, 1));
  motion.robots.push_back(
      shuttling({1.0, 1.25, 2.0, 3.0, 15.0}, {Side::kEast, 2}, motion.times_s, -1));
  return motion;
}

RobotFit fitted(const RecordedMotion& motion, Side side = Side::kWest) {
  RobotFit fit;
  fit.add(motion, side);
  return fit;
}

void expect_reached(const Estimate& estimate, double truth) {
  ASSERT_TRUE(estimate.number);
  EXPECT_NEAR(estimate.number->value, truth, 0.05 * truth);
  EXPECT_LT(estimate.number->low, truth);
  EXPECT_GT(estimate.number->high, truth);
  EXPECT_LT(estimate.number->high - estimate.number->low, 0.2 * truth);
}

TEST(RobotFit, FindsTheLimitsOfRobotsThatReachThem) {
  const RobotFit fit = fitted(shuttles(400));
  const Limits limits;
  expect_reached(fit.speed_mps(), limits.speed_mps);
  expect_reached(fit.acceleration_mps2(), limits.acceleration_mps2);
  expect_reached(fit.braking_mps2(), limits.braking_mps2);
  expect_reached(fit.angular_speed_radps(), limits.angular_speed_radps);
  expect_reached(fit.angular_acceleration_radps2(), limits.angular_acceleration_radps2);
}

TEST(RobotFit, KeepsTheSidesApart) {
  const RobotFit fit = fitted(shuttles(400), Side::kEast);
  const Limits limits;
  expect_reached(fit.speed_mps(), limits.speed_mps / 2);
  expect_reached(fit.angular_speed_radps(), limits.angular_speed_radps / 2);
}

TEST(RobotFit, HasNoNumberAfterAShortRecording) {
  const RobotFit fit = fitted(shuttles(20));
  EXPECT_GT(fit.speed_mps().episodes, 500);
  EXPECT_FALSE(fit.speed_mps().number);
}

// Two cameras see the robot 40 mm apart. Eighteen changes per minute between them affect many more
// than a thousandth of the frames.
TEST(RobotFit, DoesNotTakeAChangeOfCamerasForMotion) {
  RecordedMotion motion = shuttles(400);
  for (std::size_t i = 0; i < motion.frames(); ++i) {
    RobotSight& sight = motion.robots[0].sights[i];
    sight.camera = i / 200 % 2;
    if (sight.camera == 1) sight.position_m.x() += 0.04;
  }
  const RobotFit fit = fitted(motion);
  expect_reached(fit.speed_mps(), Limits().speed_mps);
  expect_reached(fit.braking_mps2(), Limits().braking_mps2);
}

// In three frames of each second, another robot is taken for this one.
TEST(RobotFit, DoesNotTakeAConfusionOfRobotsForMotion) {
  RecordedMotion motion = shuttles(400);
  for (std::size_t i = 0; i < motion.frames(); ++i)
    if (i % 60 < 3) motion.robots[0].sights[i].position_m.y() += 0.2;
  expect_reached(fitted(motion).speed_mps(), Limits().speed_mps);
}

// Another robot that drives beside this one may push it.
TEST(RobotFit, IgnoresAccelerationsBesideAnotherRobot) {
  RecordedMotion motion = shuttles(400);
  motion.robots[1] = motion.robots[0];
  motion.robots[1].id.side = Side::kEast;
  for (RobotSight& sight : motion.robots[1].sights) sight.position_m.y() += 0.2;
  EXPECT_EQ(fitted(motion).braking_mps2().episodes, 0);
  expect_reached(fitted(motion).speed_mps(), Limits().speed_mps);
}

}  // namespace
}  // namespace autoref::logs
