#include "live/referee/vision_quality.hpp"

#include <gtest/gtest.h>

namespace autoref::live {
namespace {

constexpr double kPeriod_s = 1.0 / 50;

league::VisionPacket packet_of(std::uint32_t camera, double x_mm) {
  league::VisionPacket packet;
  league::DetectionFrame& detection = *packet.mutable_detection();
  detection.set_camera_id(camera);
  league::DetectionRobot& robot = *detection.add_robots_yellow();
  robot.set_robot_id(3);
  robot.set_x(static_cast<float>(x_mm));
  robot.set_y(0);
  return packet;
}

Frame seen_frame_at(double time_s, bool has_ball, int robots) {
  Frame frame;
  frame.time_s = time_s;
  if (has_ball) frame.ball = BallObservation{};
  for (int number = 0; number < robots; ++number)
    frame.robots[Side::kWest].push_back({number, Vec2(0, 0), Vec2(1, 0)});
  return frame;
}

TEST(VisionQuality, CountsThePacketsOfEachCamera) {
  VisionQuality quality;
  for (int i = 0; i < 100; ++i) {
    quality.add(i * kPeriod_s, packet_of(0, 0));
    if (i % 2 == 0) quality.add(i * kPeriod_s, packet_of(1, 0));
  }
  const VisionReport report = quality.report();
  EXPECT_NEAR(report.rates_hz.at(0), 50, 1);
  EXPECT_NEAR(report.rates_hz.at(1), 25, 1);
}

TEST(VisionQuality, OnlyTheLastSecondsCount) {
  VisionQuality quality;
  for (int i = 0; i < 100; ++i) quality.add(seen_frame_at(i * kPeriod_s, false, 1));
  for (int i = 0; i < 250; ++i)
    quality.add(seen_frame_at(VisionQuality::kWindow_s + 3 + i * kPeriod_s, true, 1));
  EXPECT_DOUBLE_EQ(quality.report().ball_seen, 1);
}

TEST(VisionQuality, SaysHowOftenBallAndRobotsAreMissed) {
  VisionQuality quality;
  for (int i = 0; i < 100; ++i) quality.add(seen_frame_at(i * kPeriod_s, i % 4 != 0, i % 2 + 1));
  EXPECT_DOUBLE_EQ(quality.report().ball_seen, 0.75);
  EXPECT_DOUBLE_EQ(quality.report().robots_seen, 0.75);
}

TEST(VisionQuality, ComparesWhatTwoCamerasSayOfARobot) {
  VisionQuality quality;
  for (int i = 0; i < 20; ++i) {
    quality.add(i * kPeriod_s, packet_of(0, 1000));
    quality.add(i * kPeriod_s + 0.001, packet_of(1, 1020));
  }
  ASSERT_TRUE(quality.report().cameras_disagree_m);
  EXPECT_NEAR(*quality.report().cameras_disagree_m, 0.020, 1e-6);
}

TEST(VisionQuality, OneCameraCannotDisagree) {
  VisionQuality quality;
  for (int i = 0; i < 20; ++i) quality.add(i * kPeriod_s, packet_of(0, 1000 + i));
  EXPECT_FALSE(quality.report().cameras_disagree_m);
}

}  // namespace
}  // namespace autoref::live
