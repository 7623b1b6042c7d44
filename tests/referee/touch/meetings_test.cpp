// Where a way of the ball meets the hulls of robots.
#include "referee/touch/meetings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr double kFrame_s = 1.0 / 60;
constexpr double kTouch_m = kFrontDistance_m + kBallRadius_m;  // centre to centre, at the plate
constexpr RobotId kRobot{Side::kEast, 4};
constexpr WayParameters kWay;
constexpr MeetingParameters kMeeting;

// A ball that passes the origin evenly between two pictures, and a robot that stands. Its way is
// known from the sightings before, or, backwards, from those after.
class Passage {
 public:
  explicit Passage(const Vec2& velocity_mps) : velocity_mps_(velocity_mps) {}

  Passage& robot(const Vec2& at_m, const Vec2& heading) {
    robots_[kRobot.side].push_back({kRobot.number, at_m, heading});
    return *this;
  }
  Walk forwards(const MeetingParameters& parameters = kMeeting) {
    return walk_along(-1, parameters);
  }
  Walk backwards(const MeetingParameters& parameters = kMeeting) {
    return walk_along(1, parameters);
  }

 private:
  // Pictures -20 to 20; the origin is passed half a frame after picture -1 and before picture 0.
  Vec2 ball_at(int picture) const { return velocity_mps_ * ((picture + 0.5) * kFrame_s); }

  Walk walk_along(int from, const MeetingParameters& parameters) {
    const int sign = from < 0 ? 1 : -1;
    Pictures pictures;
    push(pictures, -1);
    push(pictures, 0);
    FreeWay way;
    const int nearest = from < 0 ? -1 : 0;
    way.start(ball_at(nearest - sign * 20), kWay);
    for (int i = nearest - sign * 19; i != nearest + sign; i += sign) {
      way.predict(sign * kFrame_s, kWay);
      way.correct(ball_at(i), kWay);
    }
    return sign > 0 ? walk(way, pictures, 0, 1, parameters) : walk(way, pictures, 1, 0, parameters);
  }
  void push(Pictures& pictures, int picture) {
    Frame frame;
    frame.time_s = (picture + 1) * kFrame_s;
    frame.robots = robots_;
    frame.ball = BallObservation{ball_at(picture), 0.0};
    pictures.push(frame);
  }

  Vec2 velocity_mps_;
  PerSide<SeenRobots> robots_;
};

// A robot beside a ball that passes along x, with its round back `gap_m` off the ball's way.
Walk passing(double gap_m, const MeetingParameters& parameters = kMeeting) {
  const Vec2 at_m(0, kRobotRadius_m + kBallRadius_m + gap_m);
  return Passage({1, 0}).robot(at_m, {0, 1}).forwards(parameters);
}

TEST(Walk, MeetsNobodyWhereNobodyIs) {
  EXPECT_TRUE(Passage({1, 0}).forwards().met.empty());
  EXPECT_TRUE(Passage({1, 0}).robot({2, 0}, {1, 0}).forwards().met.empty());
}

TEST(Walk, MeetsAHullThatItGrazesAtNoCost) {
  const Walk walk = passing(0);
  ASSERT_EQ(walk.met.size(), 1U);
  EXPECT_EQ(walk.met[0].robot, kRobot);
  EXPECT_LT(walk.met[0].bounce_cost, 0.1);
  EXPECT_LE(walk.met[0].gap_m, kMeeting.slack_m);
}

TEST(Walk, TellsTheLeastGap) { EXPECT_NEAR(passing(0.012).met[0].least_gap_m, 0.012, 2e-4); }

// Physics leaves half a millimetre between bodies that touch.
TEST(Walk, TouchesAtAGapThatPhysicsLeaves) { EXPECT_LT(passing(0.0005).met[0].bounce_cost, 0.1); }

// 4 mm beyond the slack, at a deviation of 1 mm for contact.
TEST(Walk, CostsTheSquareOfTheGap) { EXPECT_NEAR(passing(0.005).met[0].bounce_cost, 16, 2); }

TEST(Walk, CostsLessWhereRobotsAreSeenBadly) {
  MeetingParameters noisy = kMeeting;
  noisy.robot_m = 2_mm;  // with the contact's 1 mm, a variance of 5 mm2
  EXPECT_NEAR(passing(0.005, noisy).met[0].bounce_cost, 16.0 / 5, 0.5);
}

TEST(Walk, GoesThroughAHullThatStandsInItsWay) {
  // 5 mm into the hull, of which the slack is 1 mm.
  EXPECT_NEAR(passing(-0.005).through_cost, 16, 2);
  EXPECT_LT(passing(-0.0008).through_cost, 0.01);
}

// Between two pictures the ball goes from one side of the hull to the other: 0.3 frames after it
// passed the origin it is at the robot's back.
TEST(Walk, MeetsAHullThatItCrosses) {
  const double away_m = kRobotRadius_m + kBallRadius_m;
  const Walk walk = Passage({3, 0}).robot({0.015 + away_m, 0}, {1, 0}).forwards();
  ASSERT_EQ(walk.met.size(), 1U);
  EXPECT_LT(walk.met[0].bounce_cost, 0.1);
  EXPECT_NEAR(walk.met[0].time_s, 0.8 * kFrame_s, 0.1 * kFrame_s);
}

// Backwards along the way of a ball that left the origin along x: a kicker behind it, with its
// plate `gap_m` from the ball and turned by `off_rad` against the way.
Walk kicked(double gap_m, double off_rad, const MeetingParameters& parameters = kMeeting) {
  const Vec2 heading = heading_of(off_rad);
  return Passage({4, 0})
      .robot(-heading * (kTouch_m + 0.033 + gap_m), heading)
      .backwards(parameters);
}

TEST(Walk, ComesOutOfAKickersMouth) { EXPECT_LT(kicked(0.005, 0).met[0].kick_cost, 0.1); }

// Kickers reach 15 mm beyond the plate.
TEST(Walk, ComesFromNoKickerOutOfReach) {
  EXPECT_LT(kicked(0.012, 0).met[0].kick_cost, 0.1);
  EXPECT_EQ(kicked(0.025, 0).met[0].kick_cost, kNever);
}

// Three times 0.08 rad: nine.
TEST(Walk, ComesFromAKickAlongTheRobotsHeading) {
  EXPECT_NEAR(kicked(0.005, 0.24).met[0].kick_cost, 9, 1.5);
}

TEST(Walk, AllowsForHeadingsThatAreSeenBadly) {
  MeetingParameters noisy = kMeeting;
  noisy.robot_rad = 0.08;
  EXPECT_NEAR(kicked(0.005, 0.24, noisy).met[0].kick_cost, 4.5, 0.8);
}

TEST(Walk, ComesFromNoKickBackwards) {
  // It would have been kicked towards the robot.
  const Walk walk = Passage({-4, 0}).robot({-kTouch_m - 0.005 - 0.033, 0}, {1, 0}).backwards();
  ASSERT_FALSE(walk.met.empty());
  EXPECT_GT(walk.met[0].kick_cost, 100);
}

TEST(Walk, FollowsRobotsThatMove) {
  const auto gap_with = [](double moved_m) {
    Pictures pictures;
    for (int i = 0; i < 2; ++i) {
      Frame frame;
      frame.time_s = i * kFrame_s;
      frame.ball = BallObservation{Vec2(0, 0), 0.0};
      frame.robots[kRobot.side].push_back(
          {kRobot.number, Vec2(kTouch_m + 0.03 - i * moved_m, 0), Vec2(-1, 0)});
      pictures.push(frame);
    }
    FreeWay way;
    way.start({0, 0}, kWay);
    return walk(way, pictures, 0, 1, kMeeting).met.at(0).least_gap_m;
  };
  EXPECT_NEAR(gap_with(0.0), 0.030, 1e-6);
  EXPECT_NEAR(gap_with(0.02), 0.010, 1e-6);
}

}  // namespace
}  // namespace autoref::referee
