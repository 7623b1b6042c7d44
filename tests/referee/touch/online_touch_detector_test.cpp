#include "referee/touch/online_touch_detector.hpp"

#include <gtest/gtest.h>

#include "soccer/robot_shape.hpp"
#include "tests/referee/touch/touch_frames.hpp"

namespace autoref::referee {
namespace {

// Robots and a ball that follows exact paths between touches, seen at 60 Hz.
class TouchScene {
 public:
  explicit TouchScene(const Vec2& at_m) : ball_m(at_m) {}

  TouchScene& robot(Side side, int number, const Vec2& at_m, const Vec2& heading) {
    frame.robots[side].push_back({number, at_m, heading});
    return *this;
  }
  // Play starts; then the ball rests for a few frames, or moves at `velocity_mps`.
  TouchScene& start(const Vec2& velocity_mps = Vec2(0, 0)) {
    history.restart(frame, ball_m);
    detector.restart();
    ball_mps = Vec2(0, 0);
    roll(4);
    ball_mps = velocity_mps;
    return *this;
  }
  void see() {
    ++frame.number;
    frame.time_s = static_cast<double>(frame.number) * kFrame_s;
    frame.ball.reset();
    if (is_seen) frame.ball = BallObservation{ball_m, height_m};
    history.push(frame);
    detector.update();
  }
  void roll(int frames) {
    for (int i = 0; i < frames; ++i) {
      ball_m += ball_mps * kFrame_s;
      see();
    }
  }
  // Plays one frame; the velocity changes after the fraction `share` of it.
  void turn(const Vec2& velocity_mps, double share) {
    ball_m += (ball_mps * share + velocity_mps * (1 - share)) * kFrame_s;
    ball_mps = velocity_mps;
    see();
  }
  std::optional<Side> side() const { return detector.last().side; }

  Frame frame;
  Vec2 ball_m;
  Vec2 ball_mps{0, 0};
  double height_m = 0;
  bool is_seen = true;
  FrameHistory history;
  OnlineTouchDetector detector{history, Field{}, TouchParameters{}};
};

TEST(LastTouch, IsUnknownBeforeAnyTouch) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 1, {-0.3, 0}, {1, 0}).start();
  scene.roll(60);
  EXPECT_FALSE(scene.side().has_value());
}

TEST(LastTouch, IsTheKickersWithinOneFrame) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.008, 0}, {1, 0}).start();
  scene.turn({6, 0.3}, 0.5);
  ASSERT_EQ(scene.side(), Side::kWest);
  EXPECT_EQ(scene.detector.last().robot->number, 3);
  EXPECT_NEAR(scene.detector.last().gap_m, 0.008, 0.002);
  EXPECT_GT(scene.detector.last().speed_change_mps, 2);
}

TEST(LastTouch, KnowsTheTimeOfABounceOnceTheBallIsFree) {
  TouchScene scene({0, 0});
  scene.robot(Side::kEast, 2, {1 + kTouch_m, 0}, {-1, 0}).start({3, 0});
  scene.roll(19);  // at 0.95 m; it reaches the plate at 1 m, at the end of the frame
  scene.roll(1);
  scene.turn({-1, 0}, 0.0);
  scene.roll(1);
  EXPECT_EQ(scene.side(), Side::kEast);
  EXPECT_NEAR(scene.detector.last().time_s, 24 * kFrame_s, kFrame_s / 4);
}

TEST(LastTouch, MeasuresTheWholeChangeOfSpeedOnceTheBallIsFree) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.008, 0}, {1, 0}).start();
  scene.turn({6, 0}, 0.5);
  scene.roll(1);
  EXPECT_NEAR(scene.detector.last().speed_change_mps, 6, 0.1);
  EXPECT_NEAR(scene.detector.last().time_s, 4.5 * kFrame_s, 1e-6);
}

TEST(LastTouch, SurvivesAFastBallsBounceWithinAFrame) {
  TouchScene scene({0, 0});
  scene.robot(Side::kEast, 2, {1 + kTouch_m, 0}, {-1, 0}).start({8, 0});
  scene.roll(7);               // at 0.933 m
  scene.turn({-3, 0.5}, 0.5);  // half a frame to the plate, then back
  EXPECT_EQ(scene.side(), Side::kEast);
  scene.roll(3);
  EXPECT_EQ(scene.side(), Side::kEast);
}

TEST(LastTouch, IsNotByARobot144MillimetresFromTheBallsPath) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.002, 0}, {1, 0});
  scene.robot(Side::kEast, 4, {1.0, 0.144}, {0, 1}).start();
  scene.turn({4, 0}, 0.2);
  scene.roll(30);
  EXPECT_EQ(scene.side(), Side::kWest);
  EXPECT_EQ(scene.detector.last().robot->number, 1);
}

TEST(LastTouch, IsNotByARobotThatTheBallPassesAtTwoMillimetres) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.002, 0}, {1, 0});
  scene.robot(Side::kEast, 4, {1.0, 0.1135}, {0, 1}).start();
  scene.turn({2, 0}, 0.2);
  scene.roll(60);
  EXPECT_EQ(scene.side(), Side::kWest);
}

TEST(LastTouch, IsNotChangedByCarpetFriction) {
  TouchScene scene({0, 0});
  scene.robot(Side::kEast, 4, {0.5, 0.115}, {0, 1}).start({3, 0});
  scene.roll(2);
  for (int i = 0; i < 40; ++i) {
    scene.ball_mps.x() -= 3.4 * kFrame_s;  // the sliding ball's deceleration
    scene.roll(1);
  }
  EXPECT_FALSE(scene.side().has_value());
}

TEST(LastTouch, IsNotChangedByABounceOffAPost) {
  TouchScene scene({2.0, 0.361});
  scene.robot(Side::kEast, 0, {2.9, 0.1}, {-1, 0}).start({6, 0});
  scene.roll(9);
  scene.turn({-2, 0.1}, 0.9);
  scene.roll(10);
  EXPECT_FALSE(scene.side().has_value());
}

TEST(LastTouch, IsNotByARobotThatTheBallFliesOver) {
  TouchScene scene({0, 0});
  scene.robot(Side::kEast, 4, {0.5, 0.0}, {-1, 0});
  scene.height_m = 0.3;
  scene.start({4, 0});
  scene.roll(3);
  scene.turn({3.0, 0.6}, 0.5);
  scene.roll(10);
  EXPECT_FALSE(scene.side().has_value());
}

TEST(LastTouch, IsNotChangedByALanding) {
  TouchScene scene({0, 0});
  scene.robot(Side::kEast, 4, {0.5, 0.118}, {0, 1}).start({4, 0});
  scene.height_m = 0.05;
  scene.roll(7);
  scene.height_m = 0.0;
  scene.turn({3, 0}, 0.5);  // the first hop keeps three quarters of the speed
  scene.roll(10);
  EXPECT_FALSE(scene.side().has_value());
}

// This was once mistaken for a landing, because a ball at rest has no direction that could change.
TEST(LastTouch, IncludesAChipKickOfABallAtRest) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.001, 0}, {1, 0}).start();
  scene.height_m = 0.05;
  scene.turn({3, 0}, 0);
  scene.roll(4);
  EXPECT_EQ(scene.side(), Side::kWest);
}

TEST(LastTouch, IsUnknownWhenBothSidesAreEquallyNear) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.004, 0.0}, {1, 0});
  scene.robot(Side::kEast, 1, {-kTouch_m - 0.004, 0.0}, {1, 0}).start();
  scene.turn({4, 0}, 0.5);
  scene.roll(5);
  EXPECT_FALSE(scene.side().has_value());
  EXPECT_FALSE(scene.detector.last().robot.has_value());
  EXPECT_GT(scene.detector.last().time_s, 0);
}

TEST(LastTouch, IsByTheRobotHeadingInTheKicksDirection) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.004, 0}, {1, 0});
  scene.robot(Side::kEast, 5, {kTouch_m + 0.004, 0}, {-1, 0}).start();
  scene.turn({-5, 0.2}, 0.8);
  EXPECT_EQ(scene.side(), Side::kEast);
}

TEST(LastTouch, HasAKnownSideIfBothCandidatesAreTeamMates) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.004, 0.0}, {1, 0});
  scene.robot(Side::kWest, 2, {-kTouch_m - 0.004, 0.0}, {1, 0}).start();
  scene.turn({4, 0}, 0.5);
  scene.roll(3);
  EXPECT_EQ(scene.side(), Side::kWest);
  EXPECT_FALSE(scene.detector.last().robot.has_value());
}

TEST(LastTouch, IsThatOfTheSecondOfTwoTouchesInSuccessiveFrames) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.004, 0}, {1, 0});
  scene.robot(Side::kEast, 2, {0.1 + kTouch_m, 0.0}, {-1, 0}).start();
  scene.turn({6, 0}, 0.5);     // 50 mm away
  scene.turn({-2, 1.0}, 0.5);  // to the other robot's plate at 100 mm, and back
  scene.roll(4);
  EXPECT_EQ(scene.side(), Side::kEast);
}

TEST(LastTouch, IsThatOfTheSecondOfTwoTouchesWithinAFrame) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 1, {-kTouch_m - 0.004, 0}, {1, 0});
  scene.robot(Side::kEast, 2, {0.05 + kTouch_m, 0.0}, {-1, 0}).start();
  // Kicked at 6 m/s after a quarter of the frame, the ball reaches the other robot's plate after
  // three quarters.
  scene.ball_m = Vec2(0.05, 0) + Vec2(-1, 2) * (kFrame_s / 4);
  scene.ball_mps = {-1, 2};
  scene.see();
  scene.roll(4);
  EXPECT_EQ(scene.side(), Side::kEast);
}

TEST(LastTouch, IncludesPushes) {
  TouchScene scene({0, 0});
  scene.robot(Side::kEast, 3, {kTouch_m + 0.0005, 0}, {-1, 0}).start();
  for (int i = 0; i < 30; ++i) {  // slowly away, too soft for a velocity change
    scene.ball_mps = {-0.0015 * i, 0};
    scene.frame.robots[Side::kEast][0].position_m += scene.ball_mps * kFrame_s;
    scene.roll(1);
  }
  EXPECT_EQ(scene.side(), Side::kEast);
}

TEST(LastTouch, IncludesSoftTouches) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 3, {0.5, 0.1115}, {0, 1}).start({0.5, 0});
  scene.roll(60);  // at 0.5 m, at the hull
  scene.turn({0.5, -0.08}, 0.1);
  scene.roll(5);
  EXPECT_EQ(scene.side(), Side::kWest);
}

TEST(LastTouch, IsNotByARobotThatOnlyStandsNextToTheBall) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.0005, 0}, {1, 0}).start();
  scene.roll(120);
  EXPECT_FALSE(scene.side().has_value());
}

TEST(LastTouch, FollowsTheBallThroughMissedFrames) {
  TouchScene scene({0, 0});
  scene.robot(Side::kEast, 2, {1 + kTouch_m, 0}, {-1, 0}).start({3, 0});
  scene.roll(19);
  scene.is_seen = false;
  scene.roll(1);  // to the plate, not seen there
  scene.is_seen = true;
  scene.ball_mps = {-1, 0};
  scene.roll(6);
  EXPECT_EQ(scene.side(), Side::kEast);
}

TEST(LastTouch, IsUnknownWhenTheBallReappearsElsewhereAfterAGap) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.008, 0}, {1, 0}).start();
  scene.turn({2, 0}, 0.5);
  scene.roll(5);
  scene.frame.number += 30;  // half a second unseen
  scene.ball_m = {0, 1};
  scene.see();
  EXPECT_FALSE(scene.side().has_value());
}

TEST(LastTouch, IsResetAtARestart) {
  TouchScene scene({0, 0});
  scene.robot(Side::kWest, 3, {-kTouch_m - 0.008, 0}, {1, 0}).start();
  scene.turn({2, 0}, 0.5);
  scene.ball_m = {0, 1};
  scene.start();
  EXPECT_FALSE(scene.side().has_value());
  EXPECT_EQ(scene.detector.last().time_s, 0);
}

}  // namespace
}  // namespace autoref::referee
