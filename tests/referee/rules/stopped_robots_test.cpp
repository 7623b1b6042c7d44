// While play is stopped, robots must not drive fast, be near the ball, or be in the way of ball
// placement.
#include <gtest/gtest.h>

#include "tests/referee/rules/driven_game.hpp"

namespace autoref::referee {
namespace {

// Play is stopped: the ball went out over the touch line at (`x_m`, below the field) after an
// unknown touch. West 5 and east 5 keep driving so that the wait does not end.
DrivenGame stopped(const Configuration& configuration, double noise_m = 0) {
  Configuration noisy = configuration;
  noisy.noise.robot_m = noisy.noise.ball_m = noise_m;
  DrivenGame game(noisy);
  game.game.placement_works = false;
  game.game.put_ball({0.5, configuration.field.half_width_m() + 0.1});
  game.game.run(0.1);
  game.game.put_ball(game.game.signal.placement->target_m);
  game.put({Side::kWest, 5}, {-1.5, 1.0}, {-0.05, 0});
  game.put({Side::kEast, 5}, {1.5, 1.0}, {0.05, 0});
  return game;
}

// A robot drives along x at that speed, starting 2.5 s after the stop, for that long.
DrivenGame fast(const char* book, double speed_mps, double seconds = 1, double noise_m = 0,
                double wait_s = 2.5) {
  DrivenGame game = stopped(by_book(book), noise_m);
  game.put(kWest0, {-0.8, -1.0}, {0, 0});
  game.run(wait_s, noise_m);
  game.drive(kWest0, {speed_mps, 0});
  game.run(seconds, noise_m);
  game.drive(kWest0, {0, 0});
  game.run(0.5, noise_m);
  return game;
}

TEST(StopSpeed, IsNotedAboveTheBooksLimit) {
  const DrivenGame game = fast("2014", 1.05);
  ASSERT_EQ(game.calls(Event::kBotTooFastInStop).size(), 1U);
  const Decision note = game.calls(Event::kBotTooFastInStop).front();
  EXPECT_EQ(note.finding.offender, Side::kWest);
  EXPECT_EQ(note.finding.robots.front(), kWest0);
  EXPECT_NEAR(note.finding.value, 1.05, 0.02);
  EXPECT_EQ(note.finding.threshold, 1.0);
  EXPECT_EQ(note.to, State::kWaitStop);
  EXPECT_TRUE(fast("2014", 0.95).calls(Event::kBotTooFastInStop).empty());
  EXPECT_EQ(fast("2026-b", 1.55).calls(Event::kBotTooFastInStop).size(), 1U);
  EXPECT_TRUE(fast("2026-b", 1.45).calls(Event::kBotTooFastInStop).empty());
}

TEST(StopSpeed, IsNotCalledWithinTwoSecondsOfTheStop) {
  EXPECT_TRUE(fast("2014", 2.0, 1.0, 0, 0.8).calls(Event::kBotTooFastInStop).empty());
}

TEST(StopSpeed, IsNotCalledForAShortJerk) {
  EXPECT_TRUE(fast("2014", 2.0, 0.05).calls(Event::kBotTooFastInStop).empty());
}

TEST(StopSpeed, IsReportedOncePerRobotAndStop) {
  DrivenGame game = fast("2014", 1.5, 0.5);
  game.put(kEast0, {0.8, -1.4}, {0, 0});
  game.run(0.2);
  game.drive(kWest0, {-1.5, 0});
  game.drive(kEast0, {-1.5, 0});
  game.run(0.5);
  EXPECT_EQ(game.calls(Event::kBotTooFastInStop).size(), 2U);
}

TEST(StopSpeed, IsTheSameUnderNoise) {
  EXPECT_TRUE(fast("2014", 0.95, 2.0, 0.0013).calls(Event::kBotTooFastInStop).empty());
  EXPECT_EQ(fast("2014", 1.2, 0.5, 0.0013).calls(Event::kBotTooFastInStop).size(), 1U);
}

TEST(StopSpeed, IsNotCalledInThePaper) {
  EXPECT_TRUE(fast("paper", 2.0, 0.5).calls(Event::kBotTooFastInStop).empty());
}

// A robot stands with its hull at that distance from the centre of the ball, which is in position.
DrivenGame near(const char* book, double gap_m, double seconds, double noise_m = 0) {
  DrivenGame game = stopped(by_book(book), noise_m);
  const Vec2 ball_m = game.game.frame.ball->position_m;
  game.put(kWest0, ball_m - Vec2(gap_m + kRobotRadius_m, 0), {0, 0}, {-1, 0});
  game.run(seconds, noise_m);
  return game;
}

TEST(StopDistance, IsCalledWithinFiveHundredMillimetresOfTheBall) {
  const DrivenGame game = near("2014", 0.49, 6);
  ASSERT_EQ(game.calls(Event::kStopDistance).size(), 1U);
  const Decision note = game.calls(Event::kStopDistance).front();
  EXPECT_EQ(note.finding.offender, Side::kWest);
  EXPECT_EQ(note.finding.robots.front(), kWest0);
  EXPECT_NEAR(note.finding.value, 0.49, 0.001);
  EXPECT_TRUE(near("2014", 0.51, 6).calls(Event::kStopDistance).empty());
}

TEST(StopDistance, IsJudgedOnceTheBallHasBeenInPositionForTwoSeconds) {
  EXPECT_TRUE(near("2014", 0.1, 1.9).calls(Event::kStopDistance).empty());
  EXPECT_EQ(near("2014", 0.1, 2.3).calls(Event::kStopDistance).size(), 1U);
}

TEST(StopDistance, IsTheSameUnderNoise) {
  EXPECT_TRUE(near("2014", 0.505, 8, 0.0014).calls(Event::kStopDistance).empty());
  EXPECT_EQ(near("2014", 0.48, 8, 0.0014).calls(Event::kStopDistance).size(), 1U);
}

// A camera that reports every position 25 mm off sees the ball beside its target.
TEST(StopDistance, ToleratesTheCamerasLastingError) {
  for (const double camera_error_m : {0.0, 0.010}) {
    Configuration configuration = by_book("2014");
    configuration.camera_error_m = camera_error_m;
    DrivenGame game = stopped(configuration);
    const Vec2 ball_m = game.game.signal.placement->target_m + Vec2(0.025, 0);
    game.game.put_ball(ball_m);
    game.put(kWest0, ball_m - Vec2(0.3 + kRobotRadius_m, 0), {0, 0}, {-1, 0});
    game.run(6);
    EXPECT_EQ(game.calls(Event::kStopDistance).size(), camera_error_m > 0 ? 1U : 0U);
  }
}

TEST(StopDistance, IsNotCalledIn2026) {
  EXPECT_TRUE(near("2026-b", 0.1, 6).calls(Event::kStopDistance).empty());
}

// West has kicked the ball over a touch line, so that east takes a free kick. The ball is being
// placed from a metre away, and a robot stands at that distance from its path.
DrivenGame in_the_way(const char* book, RobotId robot, double gap_m, double seconds) {
  DrivenGame game(by_book(book));
  game.game.placement_works = false;
  game.game.kick(Side::kWest, 1, {0.1, 4});
  game.game.run_until("throw_in", 3);
  const Vec2 target_m = game.game.signal.placement->target_m;
  game.game.put_ball(target_m - Vec2(1, 0));
  const Vec2 position_m = target_m - Vec2(0.5, gap_m + kRobotRadius_m);
  game.put(robot, position_m, {0, 0}, {0, -1});
  game.put({Side::kWest, 5}, {-1.5, 1.0}, {-0.05, 0});
  game.put({Side::kEast, 5}, {1.5, 1.0}, {0.05, 0});
  game.run(seconds);
  return game;
}

TEST(PlacementInterference, IsCalledForTheOpponentsOfTheKickerAfterTwoSeconds) {
  const DrivenGame game = in_the_way("2026-b", kWest0, 0.49, 2.2);
  ASSERT_EQ(game.calls(Event::kBotInterferedPlacement).size(), 1U);
  EXPECT_EQ(game.calls(Event::kBotInterferedPlacement).front().finding.offender, Side::kWest);
  EXPECT_NEAR(game.calls(Event::kBotInterferedPlacement).front().finding.value, 0.49, 0.002);
  EXPECT_TRUE(
      in_the_way("2026-b", kWest0, 0.49, 1.8).calls(Event::kBotInterferedPlacement).empty());
  EXPECT_TRUE(in_the_way("2026-b", kEast0, 0.3, 4).calls(Event::kBotInterferedPlacement).empty());
}

TEST(PlacementInterference, IsNotCalledFiveHundredMillimetresAway) {
  EXPECT_TRUE(in_the_way("2026-b", kWest0, 0.51, 4).calls(Event::kBotInterferedPlacement).empty());
}

TEST(PlacementInterference, EndsOnceTheBallIsInPosition) {
  DrivenGame game = in_the_way("2026-b", kWest0, 0.1, 1.5);
  game.game.put_ball(game.game.signal.placement->target_m);
  game.run(3);
  EXPECT_TRUE(game.calls(Event::kBotInterferedPlacement).empty());
}

TEST(PlacementInterference, IsCalledOnceAndOnlyIn2026) {
  EXPECT_EQ(in_the_way("2026-b", kWest0, 0.1, 8).calls(Event::kBotInterferedPlacement).size(), 1U);
  EXPECT_TRUE(in_the_way("2014", kWest0, 0.1, 8).calls(Event::kBotInterferedPlacement).empty());
}

}  // namespace
}  // namespace autoref::referee
