#include "referee/rules/robot_collision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "soccer/random.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr double kSampled_s = 1 / 60.0;
constexpr double kContact_m = 0.18;  // two robots of 180 mm diameter

// Frames from -0.25 s to 0.07 s. West stands at the origin, east is at the distance that
// `distance_m` gives for each time.
PairPath path_of(const std::function<double(double)>& distance_m, const Vec2& line = {0.6, 0.8}) {
  PairPath path;
  for (int n = -15; n <= 4; ++n) {
    const double time_s = n * kSampled_s + 0.004;
    path.push_back({time_s, {{Vec2(0, 0), Vec2(distance_m(time_s) * line)}}});
  }
  return path;
}

std::optional<MeasuredCollision> measured(const PairPath& path, double noise_m = 0) {
  tracking::VisionNoise noise;
  noise.robot_m = noise_m;
  return measure_collision({path.data(), path.size()}, -0.05, noise);
}

// Contact at time 0 with `speed_mps`, braking; afterwards the robots part slowly.
double bounce_m(double time_s, double speed_mps, double braking_mps2) {
  if (time_s > 0) return kContact_m + 0.3 * time_s;
  return kContact_m - speed_mps * time_s + braking_mps2 / 2 * time_s * time_s;
}

TEST(RobotCollision, HasTheSpeedAndTheTimeOfTheContact) {
  const auto collision = measured(path_of([](double t) { return bounce_m(t, 1.8, 2); }));
  ASSERT_TRUE(collision);
  EXPECT_NEAR(collision->closing_mps, 1.8, 0.02);
  EXPECT_NEAR(collision->time_s, 0, 0.001);
  EXPECT_LE((collision->position_m[Side::kEast] - kContact_m * Vec2(0.6, 0.8)).norm(), 0.002);
  EXPECT_LE((collision->velocity_mps[Side::kEast] + 1.8 * Vec2(0.6, 0.8)).norm(), 0.02);
}

// 3 m/s2 over the last 0.1 s make a difference of 0.3 m/s.
TEST(RobotCollision, HasABrakingRobotsSpeedAtTheContact) {
  for (const double braking_mps2 : {0.0, 3.0, -3.0}) {
    const auto collision =
        measured(path_of([&](double t) { return bounce_m(t, 1.5, braking_mps2); }));
    ASSERT_TRUE(collision);
    EXPECT_NEAR(collision->closing_mps, 1.5, 0.03) << braking_mps2;
  }
}

TEST(RobotCollision, NeedsContact) {
  const auto with_ball_between = [](double t) { return std::max(bounce_m(t, 1.8, 0), 0.189); };
  EXPECT_FALSE(measured(path_of(with_ball_between)));
  const auto without = [](double t) { return 0.2 + std::abs(t); };
  EXPECT_FALSE(measured(path_of(without)));
}

TEST(RobotCollision, IgnoresFramesInWhichARobotIsNotSeen) {
  PairPath path = path_of([](double t) { return bounce_m(t, 1.8, 2); });
  for (const std::size_t i : {3U, 9U, 13U}) path[i].position_m[Side::kEast].reset();
  const auto collision = measured(path);
  ASSERT_TRUE(collision);
  EXPECT_NEAR(collision->closing_mps, 1.8, 0.02);
  for (PairSample& sample : path) sample.position_m[Side::kEast].reset();
  EXPECT_FALSE(measured(path));
}

// Somebody puts the robot on the field, or vision confuses two robots.
TEST(RobotCollision, IgnoresWhereARobotWasBeforeItWasRelocated) {
  PairPath path = path_of([](double t) { return bounce_m(t, 1.8, 2); });
  for (std::size_t i = 0; i < 8; ++i) *path[i].position_m[Side::kEast] += Vec2(1, 0);
  const auto collision = measured(path);
  ASSERT_TRUE(collision);
  EXPECT_NEAR(collision->closing_mps, 1.8, 0.03);
}

TEST(RobotCollision, IsTheSameFromTheOtherEnd) {
  const PairPath path = path_of([](double t) { return bounce_m(t, 1.8, 2); });
  PairPath mirrored;
  for (const PairSample& sample : path) {
    mirrored.push_back(
        {sample.time_s,
         {{Vec2(-*sample.position_m[Side::kEast]), Vec2(-*sample.position_m[Side::kWest])}}});
  }
  EXPECT_EQ(measured(path)->closing_mps, measured(mirrored)->closing_mps);
  EXPECT_EQ(measured(path)->velocity_mps[Side::kEast],
            Vec2(-measured(mirrored)->velocity_mps[Side::kWest]));
}

// The errors of robots that brake as the prior expects are as large as the stated deviation.
TEST(RobotCollision, StatesHowPreciseItIs) {
  RandomStream random(7);
  double squares = 0;
  int count = 0;
  for (int i = 0; i < 200; ++i) {
    PairPath path = path_of([](double t) { return bounce_m(t, 1.8, 2); });
    for (PairSample& sample : path) {
      for (const Side side : kSides) {
        const double dx_m = 0.0013 * random.normal();
        const double dy_m = 0.0013 * random.normal();
        *sample.position_m[side] += Vec2(dx_m, dy_m);
      }
    }
    const auto collision = measured(path, 0.0013);
    if (!collision) continue;
    squares += square((collision->closing_mps - 1.8) / collision->closing_deviation_mps);
    ++count;
  }
  EXPECT_GE(count, 180);
  const double ratio = std::sqrt(squares / count);
  EXPECT_GT(ratio, 0.3);
  EXPECT_LT(ratio, 1.3);
}

}  // namespace
}  // namespace autoref::referee
