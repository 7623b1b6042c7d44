#include <gtest/gtest.h>

#include <cmath>

#include "soccer/random.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/team_view.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"
#include "tracking/tracker.hpp"

namespace autoref::tracking {
namespace {

Frame frame_at(int number, const Vec2& robot_m, const Vec2& ball_m) {
  Frame frame;
  frame.number = number;
  frame.time_s = number / 60.0;
  frame.robots[Side::kWest].push_back({3, robot_m, heading_of(0.05 * number)});
  frame.ball = BallObservation{ball_m, 0.25};
  return frame;
}

TEST(Tracker, EstimatesVelocitiesFromTwoDetections) {
  Tracker tracker;
  tracker.update(frame_at(0, {0, 0}, {1, 0}));
  const Tracks& tracks = tracker.update(frame_at(1, {0.02, 0}, {1, -0.1}));
  const TrackedRobot& robot = tracks.robots[Side::kWest][0];
  EXPECT_EQ(robot.number, 3);
  // Approximate, since the track starts at rest and assumes a minimum detection noise.
  EXPECT_LT((robot.velocity_mps - Vec2(1.2, 0)).norm(), 0.01);
  EXPECT_NEAR(robot.angular_velocity_radps, 3.0, 0.03);
  EXPECT_LT((tracks.ball->velocity_mps - Vec2(0, -6)).norm(), 0.01);
  EXPECT_EQ(tracks.ball->height_m, 0.25);
}

TEST(Tracker, KnowsRobotsBeforeTheTimeZero) {
  Tracker tracker;
  tracker.update(frame_at(-3, {0, 0}, {1, 0}));
  tracker.update(frame_at(-2, {0.02, 0}, {1, -0.1}));
  const Tracks& tracks = tracker.update(frame_at(-1, {0.04, 0}, {1, -0.2}));
  ASSERT_EQ(tracks.robots[Side::kWest].size(), 1U);
  EXPECT_LT((tracks.robots[Side::kWest][0].velocity_mps - Vec2(1.2, 0)).norm(), 0.01);
}

TEST(Tracker, IgnoresARepeatedFrame) {
  Tracker tracker;
  tracker.update(frame_at(0, {0, 0}, {1, 0}));
  const Frame frame = frame_at(1, {0.02, 0}, {1, -0.1});
  const Tracks once = tracker.update(frame);
  const Tracks& twice = tracker.update(frame);
  EXPECT_EQ(twice.robots[Side::kWest][0].velocity_mps, once.robots[Side::kWest][0].velocity_mps);
  EXPECT_EQ(twice.ball->position_m, once.ball->position_m);
}

TEST(Tracker, EstimatesVelocityAcrossAGap) {
  Tracker tracker;
  tracker.update(frame_at(0, {0, 0}, {0, 0}));
  Frame blind = frame_at(1, {0, 0}, {0, 0});
  blind.ball.reset();
  tracker.update(blind);
  const Tracks& tracks = tracker.update(frame_at(2, {0, 0}, {0.1, 0}));
  EXPECT_NEAR(tracks.ball->velocity_mps.x(), 3.0, 0.02);
}

TEST(Tracker, ExtrapolatesAnUnseenRobotForHalfASecond) {
  Tracker tracker;
  for (int i = 0; i <= 10; ++i) tracker.update(frame_at(i, {0.02 * i, 0}, {0, 0}));
  for (int i = 11; i <= 40; ++i) {
    Frame blind = frame_at(i, {0, 0}, {0, 0});
    blind.robots[Side::kWest].clear();
    ASSERT_EQ(tracker.update(blind).robots[Side::kWest].size(), 1U) << i;
    const TrackedRobot& robot = tracker.tracks().robots[Side::kWest][0];
    ASSERT_NEAR(robot.position_m.x(), 0.02 * i, 0.002) << i;
    ASSERT_NEAR(robot.heading.dot(heading_of(0.05 * i)), 1.0, 1e-4) << i;
  }
  Frame blind = frame_at(41, {0, 0}, {0, 0});
  blind.robots[Side::kWest].clear();
  EXPECT_EQ(tracker.update(blind).robots[Side::kWest].size(), 0U);
}

// Detections of a robot and a ball at constant velocity, with the noise of the preset `realistic`.
TEST(Tracker, IsMuchBetterThanDifferencingNoisyDetections) {
  const VisionNoise noise{0.0014, 0.0013, 0.01};
  Tracker tracker(noise);
  RandomStream random(5);
  double ball_mps2 = 0;
  double robot_mps2 = 0;
  constexpr int kFrames = 600;
  constexpr int kSettled = 30;
  for (int i = 0; i < kFrames; ++i) {
    const double t_s = i / 60.0;
    Frame frame = frame_at(i, {1.5 * t_s, 0}, {3.0 * t_s - 0.15 * t_s * t_s, 1.0});
    RobotObservation& robot = frame.robots[Side::kWest][0];
    for (double* coordinate : {&robot.position_m.x(), &robot.position_m.y()}) {
      *coordinate += noise.robot_m * random.normal();
    }
    for (double* coordinate : {&frame.ball->position_m.x(), &frame.ball->position_m.y()}) {
      *coordinate += noise.ball_m * random.normal();
    }
    frame.ball->height_m = 0.0;
    const Tracks& tracks = tracker.update(frame);
    if (i < kSettled) continue;
    ball_mps2 += (tracks.ball->velocity_mps - Vec2(3.0 - 0.3 * t_s, 0)).squaredNorm();
    robot_mps2 += (tracks.robots[Side::kWest][0].velocity_mps - Vec2(1.5, 0)).squaredNorm();
  }
  // Differencing two detections gives a deviation of 2 * 60 * noise. The estimate is four times as
  // accurate for the ball, because its friction is known, and two and a half times as accurate for
  // a robot.
  EXPECT_LT(std::sqrt(ball_mps2 / (kFrames - kSettled)), noise.ball_m * 120 / 4);
  EXPECT_LT(std::sqrt(robot_mps2 / (kFrames - kSettled)), noise.robot_m * 120 / 2.5);
}

// A kick at 6 m/s, seen with noise: like the league's balls, the ball first slides, then rolls.
// Follows a ball at rest that is kicked at 6 m/s, until it has slid to 4.1 m/s. Returns the errors
// of the estimated speed; before the kick from half a second on, noise is not mistaken for motion.
struct KickErrors {
  double at_rest_mps = 0;
  double from_second_frame_mps = 0;
  double from_fifteenth_frame_mps = 0;
};

KickErrors errors_at_kick() {
  BallTracker tracker(0.0014);
  RandomStream random(6);
  KickErrors worst;
  for (int i = -60; i < 100; ++i) {
    const double t_s = i / 60.0;
    const double speed_mps = t_s < 0 ? 0 : 6.0 - 3.4 * t_s;
    const double path_m = t_s < 0 ? 0 : 6.0 * t_s - 1.7 * t_s * t_s;
    if (speed_mps < 4.1 && i > 0) break;
    BallObservation seen{{path_m, 0}, 0.0};
    seen.position_m.x() += 0.0014 * random.normal();
    seen.position_m.y() += 0.0014 * random.normal();
    const auto& ball = tracker.update(t_s + 1.0, seen, {});
    const double error_mps = (ball->velocity_mps - Vec2(speed_mps, 0)).norm();
    const auto note = [&](double& most_mps) { most_mps = std::max(most_mps, error_mps); };
    if (i > -30 && i < 0) note(worst.at_rest_mps);
    if (i >= 2) note(worst.from_second_frame_mps);
    if (i >= 15) note(worst.from_fifteenth_frame_mps);
  }
  return worst;
}

TEST(BallTracker, DetectsAKickWithinTwoFramesAndFollowsItsSlide) {
  const KickErrors worst = errors_at_kick();
  EXPECT_LT(worst.at_rest_mps, 0.2);
  EXPECT_LT(worst.from_second_frame_mps, 0.35);
  EXPECT_LT(worst.from_fifteenth_frame_mps, 0.2);
}

// Updates the tracker at 60 Hz without a detection, from one frame to another.
TrackedBall unseen_until(BallTracker& tracker, int first, int last) {
  std::optional<TrackedBall> ball;
  for (int i = first; i <= last; ++i) ball = tracker.update(i / 60.0, std::nullopt, {});
  return ball.value();
}

// A tracker that has seen a ball roll at 1 m/s for half a second.
BallTracker tracker_of_rolling_ball() {
  BallTracker tracker(0);
  for (int i = 0; i <= 30; ++i) tracker.update(i / 60.0, BallObservation{{i / 60.0, 0}, 0.0}, {});
  return tracker;
}

TEST(BallTracker, ExtrapolatesAnUnseenBallForHalfASecond) {
  BallTracker tracker = tracker_of_rolling_ball();
  const double rolled_m = unseen_until(tracker, 31, 60).position_m.x();
  EXPECT_GT(rolled_m, 0.9);
  EXPECT_LT(rolled_m, 1.0);
  unseen_until(tracker, 61, 200);
  const TrackedBall ball = unseen_until(tracker, 240, 240);
  EXPECT_NEAR(ball.position_m.x(), rolled_m, 0.03);
  EXPECT_EQ(ball.velocity_mps, Vec2(0, 0));
}

TEST(BallTracker, MovesAnOccludedBallWithTheRobotThatHeldIt) {
  BallTracker tracker(0);
  PerSide<TrackedRobots> robots;
  robots[Side::kEast].push_back({7, {1, 0}, {0, 1}, {0, 0}, 0});
  TrackedRobot& robot = robots[Side::kEast][0];
  tracker.update(0, BallObservation{{1.01, 0.1}, 0.0}, robots);
  for (int i = 1; i <= 120; ++i) {
    robot.heading = heading_of(kPi / 2 + 0.02 * i);
    robot.position_m = {1 + 0.01 * i, 0};
    robot.velocity_mps = {0.6, 0};
    robot.angular_velocity_radps = 1.2;
    const auto& ball = tracker.update(i / 60.0, std::nullopt, robots);
    const Vec2 held_m = robot.position_m + to_world({0.1, -0.01}, robot.heading);
    ASSERT_LT((ball->position_m - held_m).norm(), 1e-9) << i;
  }
}

// A robot carries a ball through a bend. From a camera far away, the bend could be
// the curve of a chip.
TEST(BallTracker, KnowsThatADribbledBallDoesNotFly) {
  Tracker tracker({1_mm, 1_mm, 0.01});
  RandomStream random(3);
  Vec2 robot_m(-1, 0);
  for (int n = 0; n < 90; ++n) {
    const double turned_rad = n < 20 ? 0 : 0.05 * (n - 20);
    const Vec2 heading = heading_of(turned_rad);
    if (n > 0) robot_m += 1.2 / 60 * heading;
    const double front_m = kFrontDistance_m + kBallRadius_m;
    const Vec2 front = robot_m + front_m * heading;
    const Vec2 ball_m = front.x() < -0.7 && n < 20 ? Vec2(-0.7, 0) : front;
    const double dx_m = 1e-3 * random.normal();
    const double dy_m = 1e-3 * random.normal();
    Frame frame;
    frame.number = n;
    frame.time_s = n / 60.0;
    frame.robots[Side::kWest].push_back({3, robot_m, heading});
    frame.ball = BallObservation{ball_m + Vec2(dx_m, dy_m), std::nullopt, {{3, 2}, 4}};
    const Tracks& tracks = tracker.update(frame);
    EXPECT_EQ(tracks.ball->height_m, 0) << n;
  }
}

TEST(TeamView, RotatesTheFieldForTheEasternTeamOnly) {
  Tracker tracker;
  const Tracks& tracks = tracker.update(frame_at(0, {1, 0.5}, {2, -1}));
  RefereeSignal signal;
  signal.goals[Side::kEast] = 2;
  signal.placement = Placement{{0.5, 0.25}, false};
  TeamView west, east;
  fill_view(tracks, signal, {Play::kDirectFree, Side::kEast}, Side::kWest, west);
  fill_view(tracks, signal, {Play::kDirectFree, Side::kEast}, Side::kEast, east);
  EXPECT_EQ(west.ball.position_m, Vec2(2, -1));
  EXPECT_EQ(east.ball.position_m, Vec2(-2, 1));
  EXPECT_EQ(east.opponents[0].position_m, Vec2(-1, -0.5));
  EXPECT_EQ(east.opponents[0].heading, Vec2(-1, 0));
  EXPECT_EQ(*east.placement_m, Vec2(-0.5, -0.25));
  EXPECT_EQ(east.goals_own, 2);
  EXPECT_TRUE(east.ours);
  EXPECT_FALSE(west.ours);
}

TEST(Frame, MirroredTwiceIsItself) {
  const Frame frame = frame_at(4, {1, 2}, {-1, 0.5});
  const Frame once = mirrored(frame);
  EXPECT_TRUE(once.robots[Side::kWest].empty());
  EXPECT_EQ(once.robots[Side::kEast][0].position_m, Vec2(-1, -2));
  const Frame twice = mirrored(once);
  EXPECT_EQ(twice.robots[Side::kWest][0].heading, frame.robots[Side::kWest][0].heading);
  EXPECT_EQ(twice.ball->position_m, frame.ball->position_m);
}

}  // namespace
}  // namespace autoref::tracking
