// Intersections of the ball's path with the hulls of robots.
#include "referee/touch/hull_intersections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"
#include "tests/referee/touch/touch_frames.hpp"

namespace autoref::referee {
namespace {

constexpr RobotId kRobot{Side::kEast, 4};
constexpr BallMotionParameters kMotion;
constexpr HullIntersectionParameters kIntersection;

// A ball that passes the origin at constant velocity between two frames, and a stationary robot.
// The path is estimated from the detections before the origin or, backwards, from those after it.
class Passage {
 public:
  explicit Passage(const Vec2& velocity_mps) : velocity_mps_(velocity_mps) {}

  Passage& robot(const Vec2& at_m, const Vec2& heading) {
    robots_[kRobot.side].push_back({kRobot.number, at_m, heading});
    return *this;
  }
  Walk forwards(const HullIntersectionParameters& parameters = kIntersection) {
    return walk_along(-1, parameters);
  }
  Walk backwards(const HullIntersectionParameters& parameters = kIntersection) {
    return walk_along(1, parameters);
  }

 private:
  // Frames -20 to 20; the ball passes the origin midway between frames -1 and 0.
  Vec2 ball_at(int index) const { return velocity_mps_ * ((index + 0.5) * kFrame_s); }

  Walk walk_along(int from, const HullIntersectionParameters& parameters) {
    const int sign = from < 0 ? 1 : -1;
    FrameHistory frame_history;
    push(frame_history, -1);
    push(frame_history, 0);
    BallMotionFilter motion;
    const int nearest = from < 0 ? -1 : 0;
    motion.start(ball_at(nearest - sign * 20), kMotion);
    for (int i = nearest - sign * 19; i != nearest + sign; i += sign) {
      motion.predict(sign * kFrame_s, kMotion);
      motion.correct(ball_at(i), kMotion);
    }
    return sign > 0 ? walk(motion, frame_history, 1, 2, parameters)
                    : walk(motion, frame_history, 2, 1, parameters);
  }
  void push(FrameHistory& frame_history, int index) {
    Frame frame;
    frame.time_s = (index + 1) * kFrame_s;
    frame.robots = robots_;
    frame.ball = BallObservation{ball_at(index), 0.0};
    frame_history.push(frame);
  }

  Vec2 velocity_mps_;
  PerSide<SeenRobots> robots_;
};

// The ball passes along x; the round back of a robot is `gap_m` from its path.
Walk passing(double gap_m, const HullIntersectionParameters& parameters = kIntersection) {
  const Vec2 at_m(0, kRobotRadius_m + kBallRadius_m + gap_m);
  return Passage({1, 0}).robot(at_m, {0, 1}).forwards(parameters);
}

TEST(Walk, FindsNoIntersectionIfNoRobotIsNear) {
  EXPECT_TRUE(Passage({1, 0}).forwards().intersections.empty());
  EXPECT_TRUE(Passage({1, 0}).robot({2, 0}, {1, 0}).forwards().intersections.empty());
}

TEST(Walk, HasNoDevianceForAGrazedHull) {
  const Walk walk = passing(0);
  ASSERT_EQ(walk.intersections.size(), 1U);
  EXPECT_EQ(walk.intersections[0].robot, kRobot);
  EXPECT_LT(walk.intersections[0].bounce_deviance, 0.1);
  EXPECT_LE(walk.intersections[0].gap_m, kIntersection.slack_m);
}

TEST(Walk, ReportsTheLeastGap) {
  EXPECT_NEAR(passing(0.012).intersections[0].least_gap_m, 0.012, 2e-4);
}

// The physics engine leaves half a millimetre between touching bodies.
TEST(Walk, HasNoDevianceForTheGapsOfThePhysicsEngine) {
  EXPECT_LT(passing(0.0005).intersections[0].bounce_deviance, 0.1);
}

// The gap is 4 mm beyond the slack; the standard deviation of contact is 1 mm.
TEST(Walk, HasADevianceOfTheSquaredGap) {
  EXPECT_NEAR(passing(0.005).intersections[0].bounce_deviance, 16, 2);
}

TEST(Walk, HasASmallerDevianceIfRobotDetectionsAreNoisy) {
  HullIntersectionParameters noisy = kIntersection;
  noisy.robot_m = 2_mm;  // together with the contact's 1 mm, the variance is 5 mm2
  EXPECT_NEAR(passing(0.005, noisy).intersections[0].bounce_deviance, 16.0 / 5, 0.5);
}

TEST(Walk, AddsTheDepthOfPassingThroughAHull) {
  // The path is 5 mm inside the hull, including 1 mm of slack.
  EXPECT_NEAR(passing(-0.005).through_deviance, 16, 2);
  EXPECT_LT(passing(-0.0008).through_deviance, 0.01);
}

// The ball crosses the hull between two frames; it reaches the robot's back 0.3 frames after
// passing the origin.
TEST(Walk, FindsAHullThatItCrossesBetweenFrames) {
  const double away_m = kRobotRadius_m + kBallRadius_m;
  const Walk walk = Passage({3, 0}).robot({0.015 + away_m, 0}, {1, 0}).forwards();
  ASSERT_EQ(walk.intersections.size(), 1U);
  EXPECT_LT(walk.intersections[0].bounce_deviance, 0.1);
  EXPECT_NEAR(walk.intersections[0].time_s, 0.8 * kFrame_s, 0.1 * kFrame_s);
}

// Walks backwards along the path of a ball that left the origin along x. A kicker is behind it,
// with the plate `gap_m` from the ball and its heading rotated by `off_rad` from the path.
Walk kicked(double gap_m, double off_rad,
            const HullIntersectionParameters& parameters = kIntersection) {
  const Vec2 heading = heading_of(off_rad);
  return Passage({4, 0})
      .robot(-heading * (kTouch_m + 0.033 + gap_m), heading)
      .backwards(parameters);
}

TEST(Walk, ComesOutOfAKickersDribblerZone) {
  EXPECT_LT(kicked(0.005, 0).intersections[0].kick_deviance, 0.1);
}

// Kickers reach 15 mm beyond the plate.
TEST(Walk, DoesNotComeFromAKickerOutOfReach) {
  EXPECT_LT(kicked(0.012, 0).intersections[0].kick_deviance, 0.1);
  EXPECT_EQ(kicked(0.025, 0).intersections[0].kick_deviance, kNever);
}

// Three standard deviations of 0.08 rad, squared: 9.
TEST(Walk, ComesFromAKickAlongTheRobotsHeading) {
  EXPECT_NEAR(kicked(0.005, 0.24).intersections[0].kick_deviance, 9, 1.5);
}

TEST(Walk, AllowsForNoisyHeadings) {
  HullIntersectionParameters noisy = kIntersection;
  noisy.robot_rad = 0.08;
  EXPECT_NEAR(kicked(0.005, 0.24, noisy).intersections[0].kick_deviance, 4.5, 0.8);
}

TEST(Walk, DoesNotComeFromAKickTowardsTheRobot) {
  const Walk walk = Passage({-4, 0}).robot({-kTouch_m - 0.005 - 0.033, 0}, {1, 0}).backwards();
  ASSERT_FALSE(walk.intersections.empty());
  EXPECT_GT(walk.intersections[0].kick_deviance, 100);
}

TEST(Walk, FollowsMovingRobots) {
  const auto gap_with = [](double moved_m) {
    FrameHistory frame_history;
    for (int i = 0; i < 2; ++i) {
      Frame frame;
      frame.time_s = i * kFrame_s;
      frame.ball = BallObservation{Vec2(0, 0), 0.0};
      frame.robots[kRobot.side].push_back(
          {kRobot.number, Vec2(kTouch_m + 0.03 - i * moved_m, 0), Vec2(-1, 0)});
      frame_history.push(frame);
    }
    BallMotionFilter motion;
    motion.start({0, 0}, kMotion);
    return walk(motion, frame_history, 1, 2, kIntersection).intersections.at(0).least_gap_m;
  };
  EXPECT_NEAR(gap_with(0.0), 0.030, 1e-6);
  EXPECT_NEAR(gap_with(0.02), 0.010, 1e-6);
}

}  // namespace
}  // namespace autoref::referee
