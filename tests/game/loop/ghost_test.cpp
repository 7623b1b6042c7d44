// A side that repeats a recording in a simulated world.
#include "game/loop/ghost.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/scene.hpp"

namespace autoref::game {
namespace {

constexpr double kGhostRate_hz = 60;
constexpr RobotId kGhost{Side::kWest, 0};

// Within one second, the ghost drives 1 m to the north and turns from east to north, and the ball
// rolls 1 m to the east.
Ghost recorded_ghost() {
  Ghost ghost;
  ghost.frames.resize(2);
  ghost.frames[0].robots = {{0, {-1, 0}, {1, 0}, {0, 0.5}, 1}};
  ghost.frames[0].ball = sim::BallState{{0, 1}, {1, 0}, 0, 0, true};
  ghost.frames[1].time_s = 1;
  ghost.frames[1].robots = {{0, {-1, 1}, {0, 1}, {0, 1.5}, 2}};
  ghost.frames[1].ball = sim::BallState{{1, 1}, {0.5, 0}, 0.2, -1, false};
  return ghost;
}

// A world with two robots per side: the ghosts start where the recording does not show them, and
// the opponents are far from everything.
struct GhostScene {
  explicit GhostScene(const Ghost& ghost = recorded_ghost()) : mover(ghost) {
    scene.put_robot(kGhost, {-2, -1});
    scene.put_robot({Side::kWest, 1}, {-2, -1.5});
    scene.put_robot({Side::kEast, 0}, {2, -1});
    scene.put_robot({Side::kEast, 1}, {2, -1.5});
    scene.put_ball({0, 0});
  }
  void step_to_frame(int last) {
    while (frame < last) {
      scene.frame();
      ++frame;
      mover.move(frame / kGhostRate_hz, scene.world);
    }
  }
  double ball_error_m(const Vec2& expected_m) const {
    return (scene.ball().position_m - expected_m).norm();
  }

  sim::Scene scene{sim::quiet(), sim::specs(2, 2)};
  GhostMover mover;
  int frame = 0;
};

TEST(GhostMover, InterpolatesRobotsBetweenFrames) {
  GhostScene game;
  game.mover.move(0.5, game.scene.world);
  const sim::RobotState& robot = game.scene.robot(kGhost);
  EXPECT_NEAR((robot.position_m - Vec2(-1, 0.5)).norm(), 0, 1e-9);
  EXPECT_NEAR((robot.heading - Vec2(std::sqrt(0.5), std::sqrt(0.5))).norm(), 0, 1e-9);
  EXPECT_NEAR((robot.velocity_mps - Vec2(0, 1)).norm(), 0, 1e-9);
  EXPECT_NEAR(robot.angular_velocity_radps, 1.5, 1e-9);
}

TEST(GhostMover, InterpolatesTheBallBetweenFrames) {
  GhostScene game;
  game.mover.move(0.5, game.scene.world);
  const sim::BallState& ball = game.scene.ball();
  EXPECT_NEAR((ball.position_m - Vec2(0.5, 1)).norm(), 0, 1e-9);
  EXPECT_NEAR((ball.velocity_mps - Vec2(0.75, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR(ball.height_m, 0.1, 1e-9);
  EXPECT_NEAR(ball.vertical_mps, -0.5, 1e-9);
}

TEST(GhostMover, LetsTheBallRollIfItRolledInTheEarlierFrame) {
  Ghost ghost = recorded_ghost();
  ghost.frames[1].ball->height_m = ghost.frames[1].ball->vertical_mps = 0;
  GhostScene game(ghost);
  game.mover.move(0.9, game.scene.world);
  EXPECT_TRUE(game.scene.ball().is_rolling);
  game.mover.move(1, game.scene.world);
  EXPECT_FALSE(game.scene.ball().is_rolling);
}

TEST(GhostMover, TurnsARobotAlongTheShorterArc) {
  Ghost ghost = recorded_ghost();
  ghost.frames[0].robots[0].heading = heading_of(3);
  ghost.frames[1].robots[0].heading = heading_of(-3);
  GhostScene game(ghost);
  game.mover.move(0.5, game.scene.world);
  EXPECT_NEAR((game.scene.robot(kGhost).heading - Vec2(-1, 0)).norm(), 0, 1e-9);
}

TEST(GhostMover, KeepsTheHeadingHalfwayToTheOppositeOne) {
  Ghost ghost = recorded_ghost();
  ghost.frames[1].robots[0].heading = {-1, 0};
  GhostScene game(ghost);
  game.mover.move(0.5, game.scene.world);
  EXPECT_NEAR((game.scene.robot(kGhost).heading - Vec2(1, 0)).norm(), 0, 1e-9);
}

// The ghost is commanded to drive west, and an opponent stands in its way.
TEST(GhostMover, MovesRobotsAlongTheirPathWhateverThePhysicsDoes) {
  GhostScene game;
  game.scene.put_robot({Side::kEast, 0}, {-1, 0.6});
  game.scene.command(kGhost).velocity_mps = {-2, 0};
  for (int i = 1; i <= 60; ++i) {
    game.step_to_frame(i);
    const Vec2 expected_m(-1, i / kGhostRate_hz);
    EXPECT_NEAR((game.scene.robot(kGhost).position_m - expected_m).norm(), 0, 1e-6) << i;
  }
  EXPECT_GT((game.scene.robot({Side::kEast, 0}).position_m - Vec2(-1, 0.6)).norm(), 0.1);
}

TEST(GhostMover, LeavesTheOtherSideAlone) {
  GhostScene game;
  game.step_to_frame(30);
  EXPECT_NEAR((game.scene.robot(sim::kEast0).position_m - Vec2(2, -1)).norm(), 0, 1e-6);
}

TEST(GhostMover, LeavesARobotWithoutARecordingWhereItIs) {
  GhostScene game;
  const RobotId missing{Side::kWest, 1};
  game.scene.put_robot(missing, {-2, -1.5}, {1, 0}, {1, 0});
  game.mover.move(0, game.scene.world);
  game.step_to_frame(30);
  EXPECT_NEAR((game.scene.robot(missing).position_m - Vec2(-2, -1.5)).norm(), 0, 1e-6);
  EXPECT_EQ(game.scene.robot(missing).velocity_mps, Vec2(0, 0));
}

TEST(GhostMover, StopsARobotWhenItsRecordingEnds) {
  Ghost ghost = recorded_ghost();
  ghost.frames.push_back({1.5, {}, std::nullopt});
  ghost.frames.push_back({2, {}, std::nullopt});
  GhostScene game(ghost);
  game.mover.move(1.25, game.scene.world);
  EXPECT_NEAR((game.scene.robot(kGhost).position_m - Vec2(-1, 1)).norm(), 0, 1e-9);
  EXPECT_EQ(game.scene.robot(kGhost).velocity_mps, Vec2(0, 1.5));
  game.mover.move(1.75, game.scene.world);
  EXPECT_NEAR((game.scene.robot(kGhost).position_m - Vec2(-1, 1)).norm(), 0, 1e-9);
  EXPECT_EQ(game.scene.robot(kGhost).velocity_mps, Vec2(0, 0));
}

TEST(GhostMover, KeepsRobotsOffTheField) {
  GhostScene game;
  game.scene.world.take_off(kGhost);
  game.step_to_frame(30);
  EXPECT_FALSE(game.scene.world.is_on(kGhost));
  ASSERT_EQ(game.scene.world.state().robots[Side::kWest].size(), 1U);
}

TEST(GhostMover, IgnoresARecordedRobotThatTheTeamLacks) {
  Ghost ghost = recorded_ghost();
  for (GhostFrame& frame : ghost.frames) frame.robots.push_back({.number = 15});
  GhostScene game(ghost);
  game.step_to_frame(30);
  EXPECT_EQ(game.scene.world.state().robots[Side::kWest].size(), 2U);
  EXPECT_NEAR((game.scene.robot(kGhost).position_m - Vec2(-1, 0.5)).norm(), 0, 1e-6);
}

TEST(GhostMover, MovesTheBallAlongItsPath) {
  GhostScene game;
  for (int i = 1; i <= 60; ++i) {
    game.step_to_frame(i);
    EXPECT_TRUE(game.mover.moves_ball());
    EXPECT_LT(game.ball_error_m({i / kGhostRate_hz, 1}), 1e-6) << i;
  }
}

// The recorded robot stands in the way of the ball.
TEST(GhostMover, MovesTheBallAlthoughAGhostTouchesIt) {
  Ghost ghost = recorded_ghost();
  for (GhostFrame& frame : ghost.frames) frame.robots[0] = {.position_m = {0.5, 1}};
  GhostScene game(ghost);
  bool is_touched = false;
  for (int i = 1; i <= 60; ++i) {
    game.step_to_frame(i);
    is_touched = is_touched || !game.scene.world.touches().empty();
  }
  EXPECT_TRUE(is_touched);
  EXPECT_TRUE(game.mover.moves_ball());
  EXPECT_LT(game.ball_error_m({1, 1}), 1e-6);
}

TEST(GhostMover, FreesTheBallForGoodIfAnOpponentStopsIt) {
  Ghost ghost = recorded_ghost();
  for (GhostFrame& frame : ghost.frames) frame.ball->height_m = 0;
  GhostScene game(ghost);
  game.scene.put_robot({Side::kEast, 0}, {0.6, 1}, {-1, 0});
  game.step_to_frame(24);
  EXPECT_TRUE(game.mover.moves_ball());
  game.step_to_frame(57);
  EXPECT_TRUE(game.scene.world.touches().empty());
  EXPECT_TRUE(game.mover.is_ball_free());
  EXPECT_LT(game.scene.ball().position_m.x(), 0.6);
}

// In the recording, the ball comes to rest at an opponent, who is elsewhere now.
TEST(GhostMover, FreesTheBallIfATouchInTheRecordingIsMissing) {
  Ghost ghost = recorded_ghost();
  ghost.frames[1].time_s = 0.5;
  ghost.frames[1].ball = sim::BallState{{0.5, 1}, {1, 0}, 0, 0, true};
  ghost.frames.push_back(ghost.frames[1]);
  ghost.frames.back().time_s = 2;
  ghost.frames.back().ball->velocity_mps = ghost.frames[1].ball->velocity_mps = {0, 0};
  ghost.touches_s = {0.5};
  GhostScene game(ghost);
  game.step_to_frame(29);
  EXPECT_TRUE(game.mover.moves_ball());
  game.scene.put_ball({0.5, 1}, {2, 0});
  game.step_to_frame(31);
  EXPECT_FALSE(game.mover.moves_ball());
  EXPECT_FALSE(game.mover.is_ball_free());
  game.step_to_frame(45);
  EXPECT_TRUE(game.mover.is_ball_free());
  EXPECT_GT(game.scene.ball().position_m.x(), 0.6);
}

// The ball rolls past an opponent that hardly touches it, in the recording and now.
TEST(GhostMover, FollowsTheRecordingAgainIfATouchDoesNotDiffer) {
  Ghost ghost = recorded_ghost();
  ghost.frames[1].ball = sim::BallState{{1, 1}, {1, 0}, 0, 0, true};
  ghost.touches_s = {0.5};
  GhostScene game(ghost);
  game.step_to_frame(32);
  EXPECT_FALSE(game.mover.moves_ball());
  game.step_to_frame(45);
  EXPECT_TRUE(game.mover.moves_ball());
  EXPECT_LT(game.ball_error_m({0.75, 1}), 1e-6);
}

TEST(GhostMover, FreesTheBallIfTheOtherSideDoesNotLetGoOfIt) {
  Ghost ghost = recorded_ghost();
  ghost.frames[1].time_s = 3;
  for (int i = 0; i <= 20; ++i) ghost.touches_s.push_back(0.1 * i);
  for (GhostFrame& frame : ghost.frames) frame.ball = sim::BallState{{0, 1}};
  GhostScene game(ghost);
  game.step_to_frame(50);
  EXPECT_FALSE(game.mover.is_ball_free());
  game.step_to_frame(70);
  EXPECT_TRUE(game.mover.is_ball_free());
}

TEST(GhostMover, LeavesTheBallAloneWhileItIsUnknown) {
  Ghost ghost = recorded_ghost();
  ghost.frames[1].ball.reset();
  ghost.frames.push_back({2, {}, sim::BallState{{2, 1}}});
  GhostScene game(ghost);
  game.mover.move(0, game.scene.world);
  EXPECT_LT(game.ball_error_m({0, 1}), 1e-9);
  game.scene.put_ball({1, -1});
  for (const double time_s : {0.5, 1.0, 1.5}) game.mover.move(time_s, game.scene.world);
  EXPECT_LT(game.ball_error_m({1, -1}), 1e-9);
  EXPECT_TRUE(game.mover.moves_ball());
  game.mover.move(2, game.scene.world);
  EXPECT_LT(game.ball_error_m({2, 1}), 1e-9);
}

TEST(GhostMover, StandsStillAfterTheLastFrameAndFreesTheBall) {
  GhostScene game;
  game.scene.command(kGhost).velocity_mps = {2, 0};
  game.mover.move(1, game.scene.world);
  EXPECT_TRUE(game.mover.moves_ball());
  EXPECT_EQ(game.scene.robot(kGhost).velocity_mps, Vec2(0, 1.5));
  game.frame = 60;
  game.step_to_frame(120);
  EXPECT_FALSE(game.mover.moves_ball());
  EXPECT_NEAR((game.scene.robot(kGhost).position_m - Vec2(-1, 1)).norm(), 0, 1e-6);
  EXPECT_EQ(game.scene.robot(kGhost).velocity_mps, Vec2(0, 0));
  EXPECT_EQ(game.scene.robot(kGhost).angular_velocity_radps, 0);
  EXPECT_GT(game.scene.ball().position_m.x(), 1.2);
}

TEST(MirroredGhost, IsTurnedAndOnTheOtherSide) {
  const Ghost ghost = mirrored(recorded_ghost());
  EXPECT_EQ(ghost.side, Side::kEast);
  const sim::RobotState& robot = ghost.frames.at(1).robots.at(0);
  EXPECT_EQ(robot.position_m, Vec2(1, -1));
  EXPECT_EQ(robot.heading, Vec2(0, -1));
  EXPECT_EQ(robot.velocity_mps, Vec2(0, -1.5));
  EXPECT_EQ(robot.angular_velocity_radps, 2);
  EXPECT_FALSE(std::signbit(robot.heading.x()));
  const sim::BallState& ball = *ghost.frames[1].ball;
  EXPECT_EQ(ball.position_m, Vec2(-1, -1));
  EXPECT_EQ(ball.velocity_mps, Vec2(-0.5, 0));
  EXPECT_EQ(ball.height_m, 0.2);
  EXPECT_EQ(ball.vertical_mps, -1);
  EXPECT_FALSE(ball.is_rolling);
}

TEST(MirroredGhost, IsTheSameAfterMirroringTwice) {
  Ghost ghost = recorded_ghost();
  ghost.touches_s = {0.7};
  const Ghost twice = mirrored(mirrored(ghost));
  EXPECT_EQ(twice.side, ghost.side);
  EXPECT_EQ(twice.touches_s, ghost.touches_s);
  ASSERT_EQ(twice.frames.size(), ghost.frames.size());
  for (std::size_t i = 0; i < ghost.frames.size(); ++i) {
    const GhostFrame& frame = twice.frames[i];
    EXPECT_EQ(frame.time_s, ghost.frames[i].time_s);
    EXPECT_EQ(frame.robots.at(0).position_m, ghost.frames[i].robots[0].position_m);
    EXPECT_EQ(frame.robots[0].heading, ghost.frames[i].robots[0].heading);
    EXPECT_EQ(frame.robots[0].velocity_mps, ghost.frames[i].robots[0].velocity_mps);
    EXPECT_EQ(frame.ball->position_m, ghost.frames[i].ball->position_m);
    EXPECT_EQ(frame.ball->velocity_mps, ghost.frames[i].ball->velocity_mps);
  }
}

}  // namespace
}  // namespace autoref::game
