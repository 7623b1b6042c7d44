// Dribbling: over 500 mm (Laws 12), over 1 m (2026), in a straight line from the first contact.
#include <gtest/gtest.h>

#include "tests/referee/rules/driven_game.hpp"

namespace autoref::referee {
namespace {

// East 0 drives to the ball and dribbles it for `path_m` to the west, either continuously or losing
// contact halfway, with the ball 30 mm ahead.
DrivenGame dribble(const char* book, double path_m, double noise_m = 0, bool loses_it = false) {
  Configuration configuration = by_book(book);
  configuration.noise.robot_m = configuration.noise.ball_m = noise_m;
  DrivenGame game(configuration);
  game.game.put_ball({0.6, -0.8});
  game.put(kEast0, {0.6 + 0.0965 + 0.3, -0.8}, {-1, 0}, {-1, 0});
  game.run(0.3, noise_m);
  game.carry(kEast0);
  game.run(path_m / 2, noise_m);
  if (loses_it) game.carry(kEast0, 0.03);
  game.run(0.1, noise_m);
  game.carry(kEast0);
  game.run(path_m / 2 - 0.1, noise_m);
  game.carry(std::nullopt);
  game.drive(kEast0, {1, 0});
  game.run(0.5, noise_m);
  return game;
}

TEST(Dribbling, IsCalledOverFiveHundredMillimetresByTheLaws) {
  const DrivenGame game = dribble("2014", 0.53);
  ASSERT_EQ(game.calls(Event::kBotDribbledBallTooFar).size(), 1U);
  const Decision call = game.calls(Event::kBotDribbledBallTooFar).front();
  EXPECT_EQ(call.finding.offender, Side::kEast);
  EXPECT_EQ(call.finding.robots.front(), kEast0);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kWest}));
  EXPECT_GT(call.finding.value, 0.5);
  EXPECT_LE((*call.finding.details.dribble_from_m - Vec2(0.6, -0.8)).norm(), 0.03);
  EXPECT_LE((*call.finding.position_m - Vec2(0.1, -0.8)).norm(), 0.03);
}

TEST(Dribbling, IsNotCalledUpToFiveHundredMillimetres) {
  EXPECT_TRUE(dribble("2014", 0.48).calls(Event::kBotDribbledBallTooFar).empty());
}

TEST(Dribbling, IsAllowedForAMetreIn2026) {
  EXPECT_TRUE(dribble("2026-b", 0.97).calls(Event::kBotDribbledBallTooFar).empty());
  const DrivenGame game = dribble("2026-b", 1.05);
  ASSERT_EQ(game.calls(Event::kBotDribbledBallTooFar).size(), 1U);
  EXPECT_EQ(game.calls(Event::kBotDribbledBallTooFar).front().restart(),
            (Command{CommandKind::kDirectFree, Side::kWest}));
}

TEST(Dribbling, EndsWhenBallAndRobotSeparate) {
  EXPECT_TRUE(dribble("2014", 0.8, 0, true).calls(Event::kBotDribbledBallTooFar).empty());
  EXPECT_FALSE(dribble("2014", 0.8, 0, false).calls(Event::kBotDribbledBallTooFar).empty());
}

TEST(Dribbling, IsTheSameUnderNoise) {
  EXPECT_TRUE(dribble("2014", 0.47, 0.0014).calls(Event::kBotDribbledBallTooFar).empty());
  EXPECT_EQ(dribble("2014", 0.54, 0.0014).calls(Event::kBotDribbledBallTooFar).size(), 1U);
  EXPECT_TRUE(dribble("2014", 0.8, 0.0014, true).calls(Event::kBotDribbledBallTooFar).empty());
}

TEST(Dribbling, IsNotAFoulInThePaper) {
  EXPECT_TRUE(dribble("paper", 0.9).calls(Event::kBotDribbledBallTooFar).empty());
}

TEST(Dribbling, IsNotCalledForABallThatFliesOverARobot) {
  DrivenGame game(by_book("2014"));
  game.put(kEast0, {0.6, -0.8}, {-1, 0}, {-1, 0});
  game.carry(kEast0);
  game.game.frame.ball->height_m = 0.2;
  game.run(0.8);
  EXPECT_TRUE(game.calls(Event::kBotDribbledBallTooFar).empty());
}

}  // namespace
}  // namespace autoref::referee
