// Online touch detection with the vision noise of the preset `realistic`.
#include <gtest/gtest.h>

#include "referee/touch/online_touch_detector.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"
#include "tests/referee/touch/touch_frames.hpp"

namespace autoref::referee {
namespace {

constexpr tracking::VisionNoise kNoise{0.0014, 0.0013, 0.01};
constexpr double kMissed = 0.05;

// A ball on a given path past stationary robots, seen with noise; one detection in twenty is
// missed.
class NoisyScene {
 public:
  explicit NoisyScene(std::uint64_t seed) : random_(seed) {}

  void put_robot(Side side, const Vec2& at_m, const Vec2& heading) {
    robots_[side].push_back({static_cast<int>(robots_[side].size()), at_m, heading});
  }
  void start(const Vec2& ball_m) {
    see(ball_m);
    frames_.restart(frame_, ball_m);
    detector_.restart();
  }
  void see(const Vec2& ball_m) {
    ++frame_.number;
    frame_.time_s = static_cast<double>(frame_.number) * kFrame_s;
    for (const Side side : kSides) {
      frame_.robots[side].clear();
      for (const RobotObservation& robot : robots_[side]) {
        const Vec2 at_m = noisy(robot.position_m, kNoise.robot_m);
        const double off_rad = kNoise.robot_rad * random_.normal();
        frame_.robots[side].push_back(
            {robot.number, at_m, to_world(heading_of(off_rad), robot.heading)});
      }
    }
    frame_.ball.reset();
    if (random_.uniform() >= kMissed) {
      frame_.ball = BallObservation{noisy(ball_m, kNoise.ball_m), std::nullopt};
    }
    frames_.push(frame_);
    detector_.update();
  }
  // Moves the ball from `from_m` for `frames` frames; returns its final position.
  Vec2 roll(const Vec2& from_m, const Vec2& velocity_mps, int frames) {
    for (int i = 1; i <= frames; ++i) see(from_m + velocity_mps * (i * kFrame_s));
    return from_m + velocity_mps * (frames * kFrame_s);
  }
  const LastTouch& last() const { return detector_.last(); }

 private:
  Vec2 noisy(const Vec2& at_m, double noise_m) {
    const double x_m = noise_m * random_.normal();
    const double y_m = noise_m * random_.normal();
    return at_m + Vec2(x_m, y_m);
  }

  RandomStream random_;
  Frame frame_;
  PerSide<SeenRobots> robots_;
  FrameHistory frames_;
  OnlineTouchDetector detector_{frames_, Field{}, TouchParameters{}, kNoise};
};

// A ball at 1.2 m/s brushes a robot and is deflected by 30 degrees, a velocity change of 0.6 m/s
// that is hidden by the noise between single frames.
bool knows_soft_touch(std::uint64_t seed) {
  NoisyScene scene(seed);
  const double reach_m = kRobotRadius_m + kBallRadius_m;
  const Vec2 normal = heading_of(to_radians(105));  // at the point of contact, from the robot
  const Vec2 met_m(0.6, 0);
  scene.put_robot(Side::kEast, met_m - normal * reach_m, {0, -1});
  scene.put_robot(Side::kWest, {0.6, 0.45}, {0, -1});
  scene.start({0, 0});
  const Vec2 at_m = scene.roll({0, 0}, {1.2, 0}, 30);
  scene.roll(at_m, 1.2 * heading_of(to_radians(30)), 10);
  return scene.last().side == Side::kEast;
}

TEST(NoisyTouch, IsDetectedWithinTenFramesIfSoft) {
  constexpr int kTries = 400;
  int known = 0;
  for (int i = 0; i < kTries; ++i) known += knows_soft_touch(static_cast<std::uint64_t>(i)) ? 1 : 0;
  EXPECT_GE(known, 0.95 * kTries) << known;
}

// A ball rolls past three robots, 12 mm from their hulls and within a kicker's reach.
TEST(NoisyTouch, IsNotDetectedIfABallPassesRobotsClosely) {
  constexpr int kTries = 1000;
  int claimed = 0;
  for (int i = 0; i < kTries; ++i) {
    NoisyScene scene(static_cast<std::uint64_t>(i) + 1000);
    const double beside_m = kRobotRadius_m + kBallRadius_m + 12_mm;
    scene.put_robot(Side::kWest, {0.5, beside_m}, {0, 1});
    scene.put_robot(Side::kEast, {1.0, -beside_m}, {0, -1});
    scene.put_robot(Side::kEast, {1.5, beside_m}, {1, 0});
    scene.start({0, 0});
    // The ball slides first, decelerating at 3.4 m/s2 from 3 m/s to 2 m/s, then rolls.
    Vec2 ball_m(0, 0);
    double speed_mps = 3.0;
    scene.see(ball_m);
    for (int f = 0; f < 55; ++f) {
      const double slows_mps2 = speed_mps > 2.0 ? 3.4 : 0.3;
      ball_m.x() += kFrame_s * (speed_mps - slows_mps2 * kFrame_s / 2);
      speed_mps -= slows_mps2 * kFrame_s;
      scene.see(ball_m);
    }
    // The start from rest is a kick by an unknown robot, since none is near.
    claimed += scene.last().side ? 1 : 0;
  }
  EXPECT_LE(claimed, 0.01 * kTries) << claimed;
}

TEST(NoisyTouch, IsNotDetectedForABallAtRestNextToARobot) {
  constexpr int kTries = 50;
  int claimed = 0;
  for (int i = 0; i < kTries; ++i) {
    NoisyScene scene(static_cast<std::uint64_t>(i) + 5000);
    scene.put_robot(Side::kWest, {-kFrontDistance_m - kBallRadius_m, 0}, {1, 0});
    scene.start({0, 0});
    for (int f = 0; f < 600; ++f) scene.see({0, 0});
    claimed += scene.last().side ? 1 : 0;
  }
  EXPECT_LE(claimed, 1) << claimed;
}

}  // namespace
}  // namespace autoref::referee
