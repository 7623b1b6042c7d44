// Who touched the ball last, judged in hindsight.
#include "referee/touch/retrospective_touch_detector.hpp"

#include <gtest/gtest.h>

#include "soccer/random.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"
#include "tests/referee/touch/touch_frames.hpp"

namespace autoref::referee {
namespace {

constexpr tracking::VisionNoise kRealistic{0.0014, 0.0013, 0.01};

// A ball that slides or rolls between touches, and stationary robots, seen at 60 Hz.
class HindsightScene {
 public:
  explicit HindsightScene(const tracking::VisionNoise& noise = {}, std::uint64_t seed = 1)
      : noise_(noise),
        random_(seed),
        touch_detector_(frames_, Field{}, TouchHypothesisParameters{}, noise) {}

  HindsightScene& robot(Side side, int number, const Vec2& at_m, const Vec2& heading) {
    robots_[side].push_back({number, at_m, heading});
    return *this;
  }
  void start(const Vec2& ball_m) {
    ball_m_ = ball_m;
    take_frame();
    frames_.restart(frame_, ball_m);
    go({0, 0}, 10);
  }
  // Moves the ball on from its position.
  void go(const Vec2& velocity_mps, int frames, bool is_seen = true) {
    for (int i = 0; i < frames; ++i) {
      ball_m_ += velocity_mps * kFrame_s;
      take_frame();
      if (!is_seen) frame_.ball.reset();
      frames_.push(frame_);
    }
  }
  // Plays one frame; the velocity changes after the fraction `share` of it.
  void turn(const Vec2& before_mps, const Vec2& after_mps, double share) {
    ball_m_ += before_mps * (share * kFrame_s);
    go(after_mps * (1 - share), 1);
  }
  // `reported` is the online detector's last touch.
  LastTouch last(const LastTouch& reported = {}) const { return touch_detector_.detect(reported); }
  std::optional<Side> side() const { return last().side; }
  double time_s() const { return frame_.time_s; }

 private:
  void take_frame() {
    ++frame_.number;
    frame_.time_s = static_cast<double>(frame_.number) * kFrame_s;
    for (const Side side : kSides) {
      frame_.robots[side].clear();
      for (RobotObservation robot : robots_[side]) {
        robot.position_m = noisy(robot.position_m, noise_.robot_m);
        robot.heading = to_world(heading_of(noise_.robot_rad * random_.normal()), robot.heading);
        frame_.robots[side].push_back(robot);
      }
    }
    frame_.ball = BallObservation{noisy(ball_m_, noise_.ball_m), 0.0};
  }
  Vec2 noisy(const Vec2& at_m, double noise_m) {
    const double x_m = noise_m * random_.normal();
    const double y_m = noise_m * random_.normal();
    return at_m + Vec2(x_m, y_m);
  }

  tracking::VisionNoise noise_;
  RandomStream random_;
  PerSide<SeenRobots> robots_;
  Vec2 ball_m_{0, 0};
  Frame frame_;
  FrameHistory frames_;
  RetrospectiveTouchDetector touch_detector_;
};

TEST(RetrospectiveTouchDetector, FindsNoTouchOfABallAtRest) {
  HindsightScene scene;
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.002, 0}, {1, 0}).start({0, 0});
  scene.go({0, 0}, 60);
  EXPECT_FALSE(scene.side().has_value());
  EXPECT_EQ(scene.last().time_s, 0);
}

TEST(RetrospectiveTouchDetector, FindsTheKicker) {
  HindsightScene scene;
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.008, 0}, {1, 0}).start({0, 0});
  scene.turn({0, 0}, {4, 0}, 0.5);
  scene.go({4, 0}, 10);
  ASSERT_EQ(scene.side(), Side::kWest);
  EXPECT_EQ(scene.last().robot->number, 3);
  EXPECT_NEAR(scene.last().time_s, 11.5 * kFrame_s, kFrame_s);
  EXPECT_NEAR(scene.last().speed_change_mps, 4, 0.2);
}

LastTouch online_touch_by(RobotId robot, double time_s) {
  LastTouch touch;
  touch.side = robot.side;
  touch.robot = robot;
  touch.time_s = time_s;
  return touch;
}

// A ball that rolls along x at 0.5 m/s, long after a kick that the online detector reported.
void roll_for_long(HindsightScene& scene, const Vec2& robot_m) {
  scene.robot(Side::kEast, 2, robot_m, {-1, 0}).start({-2, 0});
  scene.go({0.5, 0}, 400);
}

TEST(RetrospectiveTouchDetector, ReturnsTheReportedTouchIfNobodyTouchedTheBallSince) {
  HindsightScene scene;
  roll_for_long(scene, {3, 2});
  const RobotId kicker{Side::kWest, 5};
  const LastTouch last = scene.last(online_touch_by(kicker, 11 * kFrame_s));
  EXPECT_EQ(last.robot, kicker);
  EXPECT_EQ(last.time_s, 11 * kFrame_s);
  EXPECT_FALSE(last.runner_up.has_value());
}

TEST(RetrospectiveTouchDetector, FindsATouchAfterTheReportedOne) {
  const RobotId kicker{Side::kWest, 5};
  HindsightScene scene;
  roll_for_long(scene, {-2 + 400 * 0.5 * kFrame_s + kTouch_m + 0.002, 0});
  scene.go({-0.3, 0.4}, 10);
  const LastTouch last = scene.last(online_touch_by(kicker, 11 * kFrame_s));
  EXPECT_EQ(last.robot, (RobotId{Side::kEast, 2}));
  EXPECT_EQ(last.runner_up, kicker);
  EXPECT_NEAR(last.time_s, scene.time_s() - 10 * kFrame_s, kFrame_s);
  EXPECT_NEAR(last.speed_change_mps, 0.9, 0.1);
}

TEST(RetrospectiveTouchDetector, NamesTheOtherSidesLikeliestRobot) {
  HindsightScene scene;
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.008, 0}, {1, 0});
  scene.robot(Side::kEast, 6, {0, kRobotRadius_m + kBallRadius_m + 0.004}, {0, 1});
  scene.start({0, 0});
  scene.turn({0, 0}, {4, 0}, 0.5);
  scene.go({4, 0}, 10);
  EXPECT_EQ(scene.last().robot, (RobotId{Side::kWest, 3}));
  EXPECT_EQ(scene.last().runner_up, (RobotId{Side::kEast, 6}));
}

// The ball is unseen for 150 ms, but only one robot is near.
TEST(RetrospectiveTouchDetector, FindsWhoDeflectedAHiddenBall) {
  HindsightScene scene;
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.002, 0}, {1, 0});
  scene.robot(Side::kEast, 2, {1 + kTouch_m, 0}, {-1, 0});
  scene.start({0, 0});
  scene.turn({0, 0}, {3, 0}, 0.0);
  scene.go({3, 0}, 14);
  EXPECT_EQ(scene.side(), Side::kWest);
  scene.go({3, 0}, 5, false);  // to the plate
  scene.go({-1, 0.4}, 4, false);
  scene.go({-1, 0.4}, 8);
  EXPECT_EQ(scene.side(), Side::kEast);
}

TEST(RetrospectiveTouchDetector, IgnoresARobotThatAHiddenBallPasses) {
  HindsightScene scene;
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.002, 0}, {1, 0});
  scene.robot(Side::kEast, 2, {0.7, 0.125}, {0, 1});
  scene.start({0, 0});
  scene.turn({0, 0}, {3, 0}, 0.0);
  scene.go({3, 0}, 9);
  scene.go({3, 0}, 10, false);
  scene.go({3, 0}, 10);
  EXPECT_EQ(scene.side(), Side::kWest);
}

TEST(RetrospectiveTouchDetector, IsUndecidedIfBothSidesAreAtTheSamePosition) {
  HindsightScene scene;
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.004, 0}, {1, 0});
  scene.robot(Side::kEast, 1, {-kTouch_m - 0.004, 0}, {1, 0});
  scene.start({0, 0});
  scene.turn({0, 0}, {4, 0}, 0.5);
  scene.go({4, 0}, 10);
  EXPECT_GT(scene.last().time_s, 10 * kFrame_s);
  EXPECT_FALSE(scene.side().has_value());
}

// The side found for a ball that leaves the gap between two plates sideways. The gaps to the plates
// are too small to make one touch likelier than the other.
std::optional<Side> side_of_squeeze(double west_gap_m, double east_gap_m) {
  HindsightScene scene;
  scene.robot(Side::kWest, 1, {-kTouch_m - west_gap_m, 0}, {1, 0});
  scene.robot(Side::kEast, 2, {kTouch_m + east_gap_m, 0}, {-1, 0});
  scene.start({0, 0});
  scene.turn({0, 0}, {0, 2}, 0.5);
  scene.go({0, 2}, 10);
  return scene.side();
}

TEST(RetrospectiveTouchDetector, FindsTheNearerOfTwoRobotsThatSqueezedTheBall) {
  EXPECT_EQ(side_of_squeeze(0, 0.0005), Side::kWest);
  EXPECT_EQ(side_of_squeeze(0.0005, 0), Side::kEast);
}

TEST(RetrospectiveTouchDetector, FindsTheSecondOfTwoTouchesWithinAFrame) {
  HindsightScene scene;
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.004, 0}, {1, 0});
  scene.robot(Side::kEast, 2, {0.05 + kTouch_m, 0.0}, {-1, 0});
  scene.start({0, 0});
  // Kicked at 6 m/s after a quarter of the frame, the ball reaches the other robot's plate after
  // three quarters.
  scene.turn(Vec2(0.05 / (0.75 * kFrame_s), 0), {-1, 2}, 0.75);
  scene.go({-1, 2}, 10);
  EXPECT_EQ(scene.side(), Side::kEast);
}

// The side found for a brush that deflects a ball at 1 m/s by 8 degrees, 1 mm from a robot's hull.
std::optional<Side> side_of_brush(const tracking::VisionNoise& noise, std::uint64_t seed,
                                  bool is_turned) {
  HindsightScene scene(noise, seed);
  const Vec2 normal = heading_of(to_radians(94));
  const double sign = is_turned ? -1 : 1;
  const auto own = [&](Side side) { return is_turned ? opponent_of(side) : side; };
  const Vec2 at_m = Vec2(0.8, 0) - normal * (kRobotRadius_m + kBallRadius_m + 0.001);
  scene.robot(own(Side::kWest), 1, Vec2(-kTouch_m - 0.002, 0) * sign, Vec2(1, 0) * sign);
  scene.robot(own(Side::kEast), 2, at_m * sign, Vec2(0, -1) * sign);
  scene.start({0, 0});
  scene.turn({0, 0}, Vec2(1, 0) * sign, 0.0);
  scene.go(Vec2(1, 0) * sign, 47);
  scene.go(heading_of(to_radians(8)) * sign, 20);
  return scene.side();
}

TEST(RetrospectiveTouchDetector, FindsABrushThatNoiseHidesAtFirst) {
  int known = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    known += side_of_brush(kRealistic, seed, false) == Side::kEast ? 1 : 0;
  }
  EXPECT_GE(known, 47);
}

TEST(RetrospectiveTouchDetector, SwapsSidesIfTheSceneIsRotated) {
  EXPECT_EQ(side_of_brush({}, 0, false), Side::kEast);
  EXPECT_EQ(side_of_brush({}, 0, true), Side::kWest);
}

}  // namespace
}  // namespace autoref::referee
