#include "logs/fit/rig_fit.hpp"

#include <gtest/gtest.h>

#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

constexpr double kInterval_s = 1.0 / 73.2;

RecordedMotion captures(double phase_s) {
  RecordedMotion motion;
  motion.interval_s = kInterval_s;
  for (int i = 0; i < 200; ++i) {
    motion.captures_s[2].push_back(i * kInterval_s);
    motion.captures_s[5].push_back(i * kInterval_s + phase_s);
  }
  return motion;
}

TEST(RigFit, FindsRateAndPhaseOfEachCamera) {
  RigFit fit;
  fit.add(captures(0.004));
  const auto cameras = fit.cameras();
  EXPECT_NEAR(cameras.at(5).rate_hz, 73.2, 1e-6);
  EXPECT_NEAR(cameras.at(5).phase_s.value, 0.004, 1e-6);
  EXPECT_NEAR(cameras.at(5).phase_s.deviation, 0, 1e-6);
  EXPECT_EQ(cameras.at(2).captures, 200);
  EXPECT_TRUE(fit.cameras_run_freely());
}

TEST(RigFit, ALatePhaseIsNegative) {
  RigFit fit;
  fit.add(captures(kInterval_s - 0.001));
  EXPECT_NEAR(fit.cameras().at(5).phase_s.value, -0.001, 1e-6);
}

TEST(RigFit, CamerasInStepDoNotRunFreely) {
  RigFit fit;
  fit.add(captures(0));
  EXPECT_FALSE(fit.cameras_run_freely());
}

TEST(RigFit, ComparesAllCamerasWithEachOther) {
  RecordedMotion motion = captures(0.04 * kInterval_s);
  for (const double time_s : motion.captures_s[2])
    motion.captures_s[7].push_back(time_s - 0.04 * kInterval_s);
  RigFit fit;
  fit.add(motion);
  EXPECT_TRUE(fit.cameras_run_freely());
}

TEST(RigFit, CamerasOfDifferentRatesRunFreely) {
  RecordedMotion motion = captures(0);
  for (int i = 0; i < 200; ++i) motion.captures_s[5][static_cast<std::size_t>(i)] = i * 0.015;
  RigFit fit;
  fit.add(motion);
  EXPECT_TRUE(fit.cameras_run_freely());
}

// A robot drives past the seam of two cameras, again and again. They disagree by `jump_m`. The
// first one captures `early_s` before the frame's time.
RecordedMotion handovers(int count, double jump_m, double speed_mps = 0.2, double early_s = 0) {
  RecordedMotion motion;
  motion.interval_s = kInterval_s;
  motion.robots.resize(1);
  RandomStream random(2);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 20; ++k) {
      const bool is_second = k >= 10;
      const double early_now_s = is_second ? 0 : early_s;
      const double x_m = speed_mps * (kInterval_s * (k - 10) - early_now_s);
      const Vec2 noise_m = 0.0005 * Vec2(random.normal(), random.normal());
      motion.times_s.push_back(static_cast<double>(motion.frames()) * kInterval_s);
      motion.robots[0].sights.push_back({Vec2(x_m, is_second ? jump_m : 0) + noise_m, 0,
                                         is_second ? 1U : 0U, true, true,
                                         motion.times_s.back() - early_now_s});
    }
    // An unseen robot in between
    for (int k = 0; k < 8; ++k) {
      motion.times_s.push_back(static_cast<double>(motion.frames()) * kInterval_s);
      motion.robots[0].sights.emplace_back();
    }
  }
  return motion;
}

TEST(RigFit, FindsByHowMuchCamerasDisagree) {
  RigFit fit;
  fit.add(handovers(40, 0.02));
  const Estimate error_m = fit.camera_error_m();
  EXPECT_EQ(error_m.episodes, 40);
  ASSERT_TRUE(error_m.number);
  EXPECT_NEAR(error_m.number->value, 0.01, 0.0005);
}

TEST(RigFit, ComparesRobotsAtTheTimesOfCapture) {
  RigFit fit;
  fit.add(handovers(40, 0.02, 0.9, 0.008));
  const Estimate error_m = fit.camera_error_m();
  EXPECT_EQ(error_m.episodes, 40);
  ASSERT_TRUE(error_m.number);
  EXPECT_NEAR(error_m.number->value, 0.01, 0.0005);
}

// Clocks of cameras may differ by some milliseconds.
TEST(RigFit, LeavesOutFastRobots) {
  RigFit fit;
  fit.add(handovers(40, 0.02, 3, 0.008));
  EXPECT_EQ(fit.camera_error_m().episodes, 0);
}

// A simulated camera's errors at a seam are 0.51 to 1.47 times those of the whole field.
TEST(RigFit, SeamsDoNotShowTheWholeField) {
  RigFit fit;
  fit.add(handovers(40, 0.02));
  const Estimate error_m = fit.camera_error_m();
  ASSERT_TRUE(error_m.number);
  EXPECT_LT(error_m.number->low, 0.007);
  EXPECT_GT(error_m.number->high, 0.019);
}

TEST(RigFit, AFewHandoversAreNotEnough) {
  RigFit fit;
  fit.add(handovers(5, 0.02));
  EXPECT_EQ(fit.camera_error_m().number, std::nullopt);
}

TEST(RigFit, AMisreadNumberIsNotADisagreement) {
  RigFit fit;
  fit.add(handovers(40, 0.02));
  fit.add(handovers(3, 1.5));
  EXPECT_EQ(fit.camera_error_m().episodes, 40);
}

TEST(RigFit, ComparesTwoCamerasThatSeeARestingRobot) {
  RecordedMotion motion = handovers(1, 0);
  for (RobotSight& sight : motion.robots[0].sights) sight = {{1, 1}, 0, 0, true, true};
  motion.robots[0].id = {Side::kWest, 3};
  while (motion.frames() < 2000) {
    motion.times_s.push_back(motion.times_s.back() + kInterval_s);
    motion.robots[0].sights.push_back({{1, 1}, 0, 0, true, true});
  }
  for (std::size_t i = 0; i < motion.frames(); ++i)
    motion.double_sights.push_back({i, {Side::kWest, 3}, 0, 1, {0.012, 0.016}});
  RigFit fit;
  fit.add(motion);
  ASSERT_TRUE(fit.camera_error_m().number);
  EXPECT_NEAR(fit.camera_error_m().number->value, 0.01, 1e-9);
}

}  // namespace
}  // namespace autoref::logs
