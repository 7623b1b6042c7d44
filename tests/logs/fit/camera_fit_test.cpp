#include "logs/fit/camera_fit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "soccer/random.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kSceneRate_hz = 60;
constexpr double kBallNoise_m = 0.0012;
constexpr double kRobotNoise_m = 0.0006;
constexpr double kRobotNoise_rad = 0.007;
constexpr int kRobots = 4;
const Vec2 kFarFromRobots_m(0, 3);

void expect_estimate(const Estimate& estimate, double truth, double tolerance) {
  ASSERT_TRUE(estimate.number);
  EXPECT_NEAR(estimate.number->value, truth, tolerance * truth);
  EXPECT_LE(estimate.number->low, truth);
  EXPECT_GE(estimate.number->high, truth);
  EXPECT_LT(estimate.number->high - estimate.number->low, truth);
}

// Robots that stand in a row and face the camera above the centre, and a ball, all seen with noise.
class StandingRobots {
 public:
  explicit StandingRobots(double length_s) {
    motion_.field.length_m = 12;
    motion_.field.width_m = 9;
    motion_.cameras[0] = {};
    motion_.interval_s = 1 / kSceneRate_hz;
    const auto frames = static_cast<std::size_t>(length_s * kSceneRate_hz);
    for (std::size_t i = 0; i < frames; ++i)
      motion_.times_s.push_back(static_cast<double>(i) / kSceneRate_hz);
    motion_.is_running.assign(frames, 1);
    motion_.nearest_robot.assign(frames, 0);
    motion_.nearest_m.assign(frames, kFarFromRobots_m.norm());
    for (int number = 0; number < kRobots; ++number) {
      RobotMotion robot{{Side::kWest, number}, {}};
      for (std::size_t i = 0; i < frames; ++i)
        robot.sights.push_back({noisy(robot_m(number), kRobotNoise_m),
                                kHeading_rad + kRobotNoise_rad * random_.normal(), 0, true, true});
      motion_.robots.push_back(std::move(robot));
    }
    for (std::size_t i = 0; i < frames; ++i)
      motion_.ball.push_back({noisy(kFarFromRobots_m, kBallNoise_m), motion_.times_s[i], 0, true});
  }

  static Vec2 robot_m(int robot) { return {-3, 0.6 * robot}; }

  void put_ball(std::size_t frame, const Vec2& position_m, double misses) {
    motion_.ball[frame].position_m = noisy(position_m, kBallNoise_m);
    motion_.ball[frame].is_seen = random_.uniform() >= misses;
    motion_.nearest_m[frame] = (position_m - robot_m(0)).norm();
  }

  CameraFit fit() const {
    CameraFit fit;
    fit.add(motion_);
    return fit;
  }

  RecordedMotion& motion() { return motion_; }
  RandomStream& random() { return random_; }

 private:
  static constexpr double kHeading_rad = 0;

  Vec2 noisy(const Vec2& position_m, double noise_m) {
    const double x_m = noise_m * random_.normal();
    const double y_m = noise_m * random_.normal();
    return position_m + Vec2(x_m, y_m);
  }

  RecordedMotion motion_;
  RandomStream random_{4};
};

constexpr double kFarMisses = 0.04;
constexpr double kNearMisses = 0.4;
constexpr double kNearLength_m = 0.07;

// The ball rests ahead of the first robot for a second each, at several gaps, and far away for as
// long in total. It is missed as often as a simulated ball.
StandingRobots robots_with_ball(double length_s) {
  constexpr std::array kGaps_m = {0.01, 0.03, 0.06, 0.1, 0.2};
  StandingRobots scene(length_s);
  for (std::size_t i = 0; i < scene.motion().frames(); ++i) {
    const std::size_t turn = i / static_cast<std::size_t>(kSceneRate_hz) % (2 * kGaps_m.size());
    if (turn >= kGaps_m.size()) {
      scene.put_ball(i, kFarFromRobots_m, kFarMisses);
      continue;
    }
    const double share = kNearMisses * std::exp(-kGaps_m[turn] / kNearLength_m);
    scene.put_ball(i, StandingRobots::robot_m(0) + Vec2(kRobotRadius_m + kGaps_m[turn], 0),
                   1 - (1 - kFarMisses) * (1 - share));
  }
  return scene;
}

TEST(CameraFit, FindsTheFrameRateDespiteLostFrames) {
  StandingRobots scene(60);
  double lost_s = 0;
  for (std::size_t i = 0; i < scene.motion().frames(); ++i) {
    if (i % 10 == 0) lost_s += 1 / kSceneRate_hz;
    scene.motion().times_s[i] += lost_s;
  }
  const Estimate rate_hz = scene.fit().frame_rate_hz();
  ASSERT_TRUE(rate_hz.number);
  EXPECT_NEAR(rate_hz.number->value, kSceneRate_hz, 1e-6);
  EXPECT_NEAR(rate_hz.number->high, kSceneRate_hz, 0.01);
}

TEST(CameraFit, FindsTheNoiseOfBallAndRobots) {
  const CameraFit fit = StandingRobots(120).fit();
  expect_estimate(fit.ball_noise_m(), kBallNoise_m, 0.03);
  expect_estimate(fit.robot_noise_m(), kRobotNoise_m, 0.02);
  expect_estimate(fit.robot_noise_rad(), kRobotNoise_rad, 0.02);
}

TEST(CameraFit, DoesNotTakeAShakingRobotForNoise) {
  constexpr double kShaking_m = 0.02;
  constexpr double kPeriod = 5;  // frames
  StandingRobots scene(120);
  std::size_t frame = 0;
  for (RobotSight& sight : scene.motion().robots[0].sights)
    sight.position_m.x() += kShaking_m * std::sin(2 * kPi / kPeriod * static_cast<double>(frame++));
  expect_estimate(scene.fit().robot_noise_m(), kRobotNoise_m, 0.03);
}

TEST(CameraFit, FindsHowOftenTheBallIsMissedNearRobots) {
  const CameraFit fit = robots_with_ball(600).fit();
  expect_estimate(fit.ball_misses(), kFarMisses, 0.1);
  expect_estimate(fit.ball_misses_near_robots(), kNearMisses, 0.1);
  expect_estimate(fit.near_robots_m(), kNearLength_m, 0.15);
}

// The robots' shadows point away from the camera.
TEST(CameraFit, DoesNotCountHiddenBallsAsMissed) {
  constexpr std::size_t kHidden = 7;  // one second in so many
  const Vec2 hidden_m = StandingRobots::robot_m(0) - Vec2(kRobotRadius_m + 0.03, 0);
  StandingRobots scene = robots_with_ball(600);
  for (std::size_t i = 0; i < scene.motion().frames(); ++i) {
    if (i / static_cast<std::size_t>(kSceneRate_hz) % kHidden == 0)
      scene.put_ball(i, hidden_m, 0.8);
  }
  const CameraFit fit = scene.fit();
  expect_estimate(fit.ball_misses(), kFarMisses, 0.1);
  expect_estimate(fit.ball_misses_near_robots(), kNearMisses, 0.1);
  expect_estimate(fit.near_robots_m(), kNearLength_m, 0.15);
}

TEST(CameraFit, OnlyUsesBallsFarFromRobotsIfItDoesNotKnowTheCameras) {
  StandingRobots scene = robots_with_ball(600);
  scene.motion().cameras.clear();
  const CameraFit fit = scene.fit();
  expect_estimate(fit.ball_misses(), kFarMisses, 0.1);
  EXPECT_FALSE(fit.ball_misses_near_robots().number);
  EXPECT_FALSE(fit.near_robots_m().number);
}

TEST(CameraFit, CountsHowOftenTheBallIsSeenByDistance) {
  const std::vector<SeenShare> seen = robots_with_ball(100).fit().ball_seen();
  ASSERT_EQ(seen.size(), 6U);
  EXPECT_DOUBLE_EQ(seen[3].distance_m, 0.15);
  EXPECT_NEAR(static_cast<double>(seen[3].frames), 10 * kSceneRate_hz, 40);
  const double share = (1 - kFarMisses) * (1 - kNearMisses * std::exp(-0.06 / kNearLength_m));
  EXPECT_NEAR(static_cast<double>(seen[3].seen) / static_cast<double>(seen[3].frames), share, 0.05);
  EXPECT_LT(seen[5].frames, 10);
}

TEST(CameraFit, DistinguishesSingleMissesOfRobotsFromGaps) {
  constexpr double kMisses = 0.02;
  constexpr double kGaps = 0.03;
  constexpr int kLongestGap = 11;  // frames, so their mean duration is 0.1 s
  StandingRobots scene(600);
  for (RobotMotion& robot : scene.motion().robots) {
    int left = 0;
    for (RobotSight& sight : robot.sights) {
      const double gap_starts = kGaps / ((1 - kGaps) * (1 + kLongestGap) / 2.0);
      if (left == 0 && scene.random().uniform() < gap_starts)
        left = 1 + static_cast<int>(scene.random().uniform() * kLongestGap);
      sight.is_seen = left == 0 && scene.random().uniform() >= kMisses;
      if (left > 0) --left;
    }
  }
  const CameraFit fit = scene.fit();
  expect_estimate(fit.robot_misses(), kMisses, 0.1);
  expect_estimate(fit.robot_gaps(), kGaps, 0.15);
  expect_estimate(fit.robot_gap_s(), 0.1, 0.1);
}

// Adds balls ahead of the robot in this share of frames.
void add_balls_ahead(StandingRobots& scene, int robot, double share) {
  for (std::size_t i = 0; i < scene.motion().frames(); ++i) {
    const double ahead_m = 0.12 + 0.02 * scene.random().uniform();
    if (scene.random().uniform() < share)
      scene.motion().other_balls.push_back({i, StandingRobots::robot_m(robot) + Vec2(ahead_m, 0)});
  }
}

TEST(CameraFit, FindsTheRateOfFalseBalls) {
  constexpr double kRate_per_s = 0.1;
  StandingRobots scene(600);
  for (int robot = 0; robot < kRobots; ++robot)
    add_balls_ahead(scene, robot, kRate_per_s / kSceneRate_hz);
  expect_estimate(scene.fit().false_balls_per_s(), kRate_per_s, 0.15);
}

TEST(CameraFit, DoesNotTakeTheDribbledBallForFalse) {
  StandingRobots scene(60);
  for (std::size_t i = 0; i < scene.motion().frames(); ++i)
    scene.put_ball(i, StandingRobots::robot_m(0) + Vec2(kFrontDistance_m + kBallRadius_m, 0), 0);
  add_balls_ahead(scene, 0, 0.1);
  const Estimate rate = scene.fit().false_balls_per_s();
  EXPECT_EQ(rate.episodes, 0);
  EXPECT_FALSE(rate.number);
}

// Moves positions by a random process with this deviation in x and y, and a memory of 0.3 s.
// They rest for four seconds, then they are elsewhere.
template <typename Sight>
void add_drift(std::vector<Sight>& sights, double drift_m, RandomStream& random) {
  const double kept = std::exp(-1 / (0.3 * kSceneRate_hz));
  const double added_m = drift_m * std::sqrt(1 - kept * kept);
  Vec2 drifted_m(0, 0);
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const double x_m = added_m * random.normal();
    const double y_m = added_m * random.normal();
    drifted_m = kept * drifted_m + Vec2(x_m, y_m);
    sights[i].position_m += drifted_m;
    if (i / static_cast<std::size_t>(4 * kSceneRate_hz) % 2 == 1) sights[i].position_m.y() += 0.2;
  }
}

TEST(CameraFit, FindsTheDriftOfRestingObjects) {
  constexpr double kDrift_m = 0.0007;
  StandingRobots scene(600);
  add_drift(scene.motion().ball, kDrift_m, scene.random());
  for (RobotMotion& robot : scene.motion().robots)
    add_drift(robot.sights, kDrift_m, scene.random());
  const CameraFit fit = scene.fit();
  ASSERT_TRUE(fit.ball_drift_m().number && fit.robot_drift_m().number);
  EXPECT_GT(fit.ball_drift_m().episodes, 100);
  EXPECT_NEAR(fit.ball_drift_m().number->value, kDrift_m, 0.3 * kDrift_m);
  EXPECT_GT(fit.ball_drift_m().number->low, 0);
  EXPECT_NEAR(fit.robot_drift_m().number->value, kDrift_m, 0.5 * kDrift_m);
}

TEST(CameraFit, ReportsNoDriftOfWhiteNoiseAndOfRobotsThatHoldTheirPosition) {
  StandingRobots scene(600);
  add_drift(scene.motion().ball, 0, scene.random());
  for (RobotMotion& robot : scene.motion().robots) add_drift(robot.sights, 2e-4, scene.random());
  const CameraFit fit = scene.fit();
  ASSERT_TRUE(fit.ball_drift_m().number && fit.robot_drift_m().number);
  EXPECT_EQ(fit.ball_drift_m().number->value, 0);
  EXPECT_LT(fit.ball_drift_m().number->high, 1e-4);
  EXPECT_EQ(fit.robot_drift_m().number->value, 0);
}

TEST(CameraFit, PoolsParts) {
  CameraFit fit;
  for (int part = 0; part < 2; ++part) fit.add(robots_with_ball(100).motion());
  const CameraFit whole = robots_with_ball(100).fit();
  EXPECT_EQ(fit.ball_noise_m().episodes, 2 * whole.ball_noise_m().episodes);
  EXPECT_EQ(fit.ball_misses().episodes, 2 * whole.ball_misses().episodes);
  EXPECT_NEAR(fit.ball_misses().number->value, whole.ball_misses().number->value, 1e-4);
}

TEST(CameraFit, HasNoEstimatesFromAFewSeconds) {
  const CameraFit fit = robots_with_ball(12).fit();
  EXPECT_FALSE(fit.ball_noise_m().number);
  EXPECT_FALSE(fit.robot_noise_m().number);
  EXPECT_FALSE(fit.ball_drift_m().number);
  EXPECT_FALSE(fit.ball_misses().number);
  EXPECT_FALSE(fit.robot_misses().number);
  EXPECT_FALSE(fit.false_balls_per_s().number);
}

}  // namespace
}  // namespace autoref::logs
