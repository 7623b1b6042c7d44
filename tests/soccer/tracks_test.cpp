#include <gtest/gtest.h>

#include "soccer/team_view.hpp"
#include "soccer/tracker.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref {
namespace {

Frame frame_at(int number, const Vec2& robot_m, const Vec2& ball_m) {
  Frame frame;
  frame.number = number;
  frame.time_s = number / 60.0;
  frame.robots[Side::kWest].push_back({3, robot_m, heading_of(0.05 * number)});
  frame.ball = BallObservation{ball_m, 0.25};
  return frame;
}

TEST(Tracker, TellsVelocitiesFromTwoSightings) {
  Tracker tracker;
  tracker.update(frame_at(0, {0, 0}, {1, 0}));
  const Tracks& tracks = tracker.update(frame_at(1, {0.02, 0}, {1, -0.1}));
  const TrackedRobot& robot = tracks.robots[Side::kWest][0];
  EXPECT_EQ(robot.number, 3);
  EXPECT_TRUE(robot.velocity_mps.isApprox(Vec2(1.2, 0), 1e-12));
  EXPECT_NEAR(robot.angular_velocity_radps, 3.0, 1e-4);
  EXPECT_TRUE(tracks.ball->velocity_mps.isApprox(Vec2(0, -6), 1e-12));
  EXPECT_EQ(tracks.ball->height_m, 0.25);
}

TEST(Tracker, MeasuresOverAGapInTheSightings) {
  Tracker tracker;
  tracker.update(frame_at(0, {0, 0}, {0, 0}));
  Frame blind = frame_at(1, {0, 0}, {0, 0});
  blind.ball.reset();
  tracker.update(blind);
  const Tracks& tracks = tracker.update(frame_at(2, {0, 0}, {0.1, 0}));
  EXPECT_NEAR(tracks.ball->velocity_mps.x(), 3.0, 1e-12);
}

TEST(Tracker, HoldsAnUnseenRobotForHalfASecond) {
  Tracker tracker;
  tracker.update(frame_at(0, {0, 0}, {0, 0}));
  Frame blind = frame_at(30, {0, 0}, {0, 0});
  blind.robots[Side::kWest].clear();
  EXPECT_EQ(tracker.update(blind).robots[Side::kWest].size(), 1U);
  blind.number = 31;
  blind.time_s = 31 / 60.0;
  EXPECT_EQ(tracker.update(blind).robots[Side::kWest].size(), 0U);
}

TEST(TeamView, TurnsTheFieldForTheEasternTeamOnly) {
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
}  // namespace autoref
