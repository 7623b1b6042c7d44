#include "league/followed_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autoref::league {
namespace {

constexpr double kTrackedFrame_s = 0.0125;

// A robot that drives along x at 1 m/s; camera 1 sees it 20 mm beside and turned by 0.02 rad.
Detected seen_by(std::uint32_t camera, double time_s) {
  const double y_m = camera == 0 ? 0 : 0.02;
  return {camera, 1, {time_s, y_m}, heading_of(camera == 0 ? 0 : 0.02)};
}

class RobotBetweenCameras : public testing::Test {
 protected:
  Detected add(const std::vector<std::uint32_t>& cameras) {
    std::vector<Detected> all;
    all.reserve(cameras.size());
    for (const std::uint32_t camera : cameras) all.push_back(seen_by(camera, time_s_));
    Detected used = robot_.add(time_s_, all, all.back());
    time_s_ += kTrackedFrame_s;
    return used;
  }
  Detected add(const std::vector<std::uint32_t>& cameras, double duration_s) {
    Detected used;
    for (const double end_s = time_s_ + duration_s; time_s_ < end_s;) used = add(cameras);
    return used;
  }

  FollowedBody robot_;
  double time_s_ = 0;
};

TEST_F(RobotBetweenCameras, StaysWithItsCamera) {
  add({0});
  EXPECT_EQ(add({0, 1}).position_m.y(), 0);
}

TEST_F(RobotBetweenCameras, DoesNotJumpToTheNextCamera) {
  add({0});
  add({0, 1});
  const Detected used = add({1});
  EXPECT_NEAR(used.position_m.y(), 0, 0.5e-3);
  EXPECT_NEAR(angle_of(used.heading), 0, 0.5e-3);
}

TEST_F(RobotBetweenCameras, ForgetsTheLastCameraWithinASecond) {
  add({0});
  add({0, 1});
  const Detected used = add({1}, 1);
  EXPECT_NEAR(used.position_m.y(), 0.02, 1e-9);
  EXPECT_NEAR(angle_of(used.heading), 0.02, 1e-9);
}

TEST_F(RobotBetweenCameras, IsWhereTheNextCameraSeesItIfNeverBothSawIt) {
  add({0});
  EXPECT_EQ(add({1}).position_m.y(), 0.02);
}

TEST_F(RobotBetweenCameras, IsExpectedWhereItsVelocityBringsIt) {
  add({0}, 1);
  EXPECT_NEAR(robot_.expected_m(time_s_ + 0.1).x(), time_s_ + 0.1, 1e-9);
  EXPECT_NEAR(robot_.expected_m(time_s_ + 10).x(), robot_.seen_s() + 0.5, 1e-9);
}

}  // namespace
}  // namespace autoref::league
