#include "referee/touch/touch_history.hpp"

#include <gtest/gtest.h>

#include "soccer/robot_shape.hpp"
#include "tests/referee/touch/touch_frames.hpp"

namespace autoref::referee {
namespace {

constexpr RobotId kWest3{Side::kWest, 3};
constexpr RobotId kEast4{Side::kEast, 4};

LastTouch touch_by(RobotId robot, double time_s) { return {robot.side, robot, time_s, 0, 1, {}}; }

// A touch history with scripted detector reports, a ball, and two robots far from the ball.
class History {
 public:
  History() {
    frame.robots[Side::kWest].push_back({3, Vec2(-2, 0), Vec2(1, 0)});
    frame.robots[Side::kEast].push_back({4, Vec2(2, 0), Vec2(-1, 0)});
    ball.emplace();
  }
  RobotObservation& west() { return frame.robots[Side::kWest].front(); }

  // Processes one frame with the detector's last touch `reported`.
  void step() {
    frame.number += 1;
    frame.time_s = static_cast<double>(frame.number) * kFrame_s;
    frame.ball = BallObservation{ball->position_m, ball->height_m};
    frame_history.push(frame);
    const RefereeInput input{configuration, frame, ball, reported, tracks, requests, frame_history};
    touches.update(input, 0.0);
  }
  void report(RobotId robot, double ago_s = 0.01) {
    reported = touch_by(robot, static_cast<double>(frame.number + 1) * kFrame_s - ago_s);
    step();
  }
  void run(int frames) {
    for (int i = 0; i < frames; ++i) step();
  }
  // Puts the west robot's plate at this distance from the ball's surface.
  void west_at_gap(double gap_m) {
    west().position_m = ball->position_m - Vec2(kFrontDistance_m + kBallRadius_m + gap_m, 0);
  }

  Configuration configuration;
  Frame frame;
  std::optional<BallSight> ball;
  LastTouch reported;
  Tracks tracks;
  PerSide<TeamRequests> requests;
  FrameHistory frame_history;
  TouchHistory touches;
};

TEST(TouchHistory, IsEmptyBeforeAnyTouch) {
  History history;
  history.run(3);
  EXPECT_EQ(history.touches.count(), 0);
  EXPECT_EQ(history.touches.newest(), nullptr);
}

TEST(TouchHistory, CountsATouchReportedInManyFramesOnce) {
  History history;
  history.report(kWest3);
  history.run(60);
  EXPECT_EQ(history.touches.count(), 1);
  EXPECT_EQ(history.touches.newest()->robot, kWest3);
}

TEST(TouchHistory, CountsAKickWithALaterRevisedTimeOnce) {
  History history;
  history.west_at_gap(0.05);  // 50 mm away in the frame that first reports the kick
  history.report(kWest3, 0.002);
  const double kicked_s = history.reported.time_s - 0.009;
  history.reported = touch_by(kWest3, kicked_s);
  history.run(3);
  EXPECT_EQ(history.touches.count(), 1);
  EXPECT_EQ(history.touches.newest()->began_s, kicked_s);
}

TEST(TouchHistory, MergesTouchesByOneRobotWhileTheBallStaysWithin20Millimetres) {
  History history;
  history.west_at_gap(0.019);
  history.report(kWest3);
  history.run(30);
  history.report(kWest3);
  EXPECT_EQ(history.touches.count(), 1);
  EXPECT_NEAR(history.touches.newest()->ended_s - history.touches.newest()->began_s, 31 * kFrame_s,
              1e-9);
}

TEST(TouchHistory, CountsANewTouchAfterTheBallWas21MillimetresAway) {
  History history;
  history.west_at_gap(0);
  history.report(kWest3);
  history.west_at_gap(0.021);
  history.run(3);
  history.report(kWest3);
  EXPECT_EQ(history.touches.count(), 2);
  EXPECT_TRUE(history.touches.is_one_robots());
}

TEST(TouchHistory, FollowsARevisionOfTheRobotInTheNextFrame) {
  History history;
  history.report(kWest3, 0.002);
  history.reported = touch_by(kEast4, history.reported.time_s - 0.004);
  history.step();
  EXPECT_EQ(history.touches.count(), 1);
  EXPECT_EQ(history.touches.newest()->robot, kEast4);
}

TEST(TouchHistory, RevertsToThePreviousTouchIfOneIsWithdrawn) {
  History history;
  history.report(kWest3);
  const LastTouch former = history.reported;
  history.run(10);
  history.report(kEast4);
  EXPECT_EQ(history.touches.count(), 2);
  history.reported = former;
  history.run(2);
  EXPECT_EQ(history.touches.count(), 1);
  EXPECT_EQ(history.touches.newest()->robot, kWest3);
}

TEST(TouchHistory, IsEmptyIfTheOnlyTouchIsWithdrawn) {
  History history;
  history.report(kWest3);
  history.reported = LastTouch{};
  history.step();
  EXPECT_EQ(history.touches.count(), 0);
}

TEST(TouchHistory, CountsTouchesByTwoRobotsInSuccessiveFramesSeparately) {
  History history;
  history.report(kWest3);
  history.report(kEast4);
  EXPECT_EQ(history.touches.count(), 2);
  EXPECT_EQ(history.touches.at(1).robot, kWest3);
  EXPECT_FALSE(history.touches.is_one_robots());
}

TEST(TouchHistory, CountsAnUnknownToucherAsASecondRobot) {
  History history;
  history.report(kWest3);
  history.run(10);
  history.reported = LastTouch{};
  history.reported.time_s = history.frame.time_s + 0.01;
  history.step();
  EXPECT_EQ(history.touches.count(), 2);
  EXPECT_FALSE(history.touches.is_one_robots());
}

TEST(TouchHistory, KnowsThePositionsOfRobotAndBallAtATouchReportedLate) {
  History history;
  history.west().position_m = Vec2(1, 0);
  for (int i = 0; i < 8; ++i) {
    history.west().position_m.x() += 0.06;  // 3.6 m/s
    history.ball->position_m.x() += 0.1;
    history.step();
  }
  history.reported = touch_by(kWest3, 3.5 * kFrame_s);
  history.step();
  const BallTouch& touch = *history.touches.newest();
  EXPECT_NEAR(touch.toucher->position_m.x(), 1 + 3.5 * 0.06, 1e-9);
  EXPECT_NEAR(touch.began_m.x(), 0.3, 1e-9);
}

TEST(TouchHistory, LocatesAKickReportedAFrameLateWhereTheBallLay) {
  History history;
  history.west_at_gap(0.01);
  history.run(3);
  history.ball->position_m.x() += 0.11;
  history.report(kWest3, 0.0);
  EXPECT_EQ(history.touches.newest()->began_m, Vec2(0, 0));
}

TEST(TouchHistory, KnowsTheGreatestHeightAndThatTheBallRollsAgain) {
  History history;
  history.report(kWest3);
  for (const double height_m : {0.1, 0.2, 0.1}) {
    history.ball->height_m = height_m;
    history.step();
  }
  history.ball->height_m = 0;
  history.run(6);
  EXPECT_FALSE(history.touches.newest()->rolled);  // 83 ms
  history.run(2);
  EXPECT_TRUE(history.touches.newest()->rolled);
  EXPECT_EQ(history.touches.newest()->highest_m, 0.2);
}

}  // namespace
}  // namespace autoref::referee
