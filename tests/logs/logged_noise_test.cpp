#include "logs/facts_collector.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

// Robots that drive in circles at 2 m/s and a ball that is kicked every second.
LoggedNoise noise_of(const tracking::VisionNoise& noise, double rate_hz, double length_s) {
  RandomStream chance(7);
  const auto blurred = [&chance](const Vec2& at, double deviation) {
    const double x = chance.normal();
    const double y = chance.normal();
    return Vec2(at + deviation * Vec2(x, y));
  };
  LoggedNoise measured;
  Frame frame;
  frame.robots[Side::kWest] = {RobotObservation{.number = 3}};
  frame.robots[Side::kEast] = {RobotObservation{.number = 0}};
  for (frame.number = 0; frame.time_s < length_s; ++frame.number) {
    frame.time_s = static_cast<double>(frame.number) / rate_hz;
    for (const Side side : kSides) {
      RobotObservation& robot = frame.robots[side].front();
      robot.position_m = blurred(heading_of(2 * frame.time_s), noise.robot_m);
      robot.heading = heading_of(3 * frame.time_s + noise.robot_rad * chance.normal());
    }
    const double since_kick_s = frame.time_s - std::floor(frame.time_s);
    frame.ball.emplace().position_m = blurred({4 * since_kick_s, 0}, noise.ball_m);
    measured.add(frame);
  }
  return measured;
}

class NoiseOf : public testing::TestWithParam<tracking::VisionNoise> {};

TEST_P(NoiseOf, IsMeasured) {
  for (const double rate_hz : {60.0, 73.0}) {
    const std::optional<tracking::VisionNoise> noise = noise_of(GetParam(), rate_hz, 30).noise();
    ASSERT_TRUE(noise);
    EXPECT_NEAR(noise->ball_m, GetParam().ball_m, 0.1 * GetParam().ball_m + 1e-9);
    EXPECT_NEAR(noise->robot_m, GetParam().robot_m, 0.1 * GetParam().robot_m + 1e-9);
    EXPECT_NEAR(noise->robot_rad, GetParam().robot_rad, 0.1 * GetParam().robot_rad + 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Vision, NoiseOf,
                         testing::Values(tracking::VisionNoise{},
                                         tracking::VisionNoise{0.0007, 0.0005, 0.005},
                                         tracking::VisionNoise{0.0014, 0.0013, 0.01},
                                         tracking::VisionNoise{0.004, 0.003, 0.03}));

TEST(LoggedNoise, IsUnknownAfterAFewFrames) { EXPECT_FALSE(noise_of({}, 60, 1).noise()); }

// Every other frame is missing for a while: intervals of 1, 2, 1, 2 frames are uneven.
TEST(LoggedNoise, IgnoresUnevenIntervals) {
  LoggedNoise measured;
  Frame frame;
  frame.robots[Side::kWest] = {{3, {0, 0}, {1, 0}}};
  frame.ball = BallObservation{};
  for (int i = 0; i < 3000; ++i) {
    frame.time_s += i % 2 == 0 ? 0.016 : 0.032;
    frame.ball->position_m.x() += i % 2 == 0 ? 0.05 : -0.02;
    measured.add(frame);
  }
  EXPECT_FALSE(measured.noise());
}

}  // namespace
}  // namespace autoref::logs
