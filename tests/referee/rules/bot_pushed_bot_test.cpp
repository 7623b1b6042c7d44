// Pushing: "both robots travel towards the opponent robot for more than 0.2 meters" (2026; Laws
// 12).
#include <gtest/gtest.h>

#include "tests/referee/rules/driven_game.hpp"

namespace autoref::referee {
namespace {

// West 0 drives away at `own_mps` until east 0 reaches it at 0.5 m/s. Both then drive on for
// `path_m` in contact, and east 0 backs off.
DrivenGame push(const char* book, double path_m, double own_mps = 0, double noise_m = 0) {
  Configuration configuration = by_book(book);
  configuration.noise.robot_m = noise_m;
  DrivenGame game(configuration);
  game.put(kWest0, {0.3 + 0.3 * own_mps, -0.8}, {-own_mps, 0});
  game.put(kEast0, {0.3 + 0.18 + 0.3 * 0.5, -0.8}, {-0.5, 0});
  game.run(0.3, noise_m);
  game.drive(kWest0, {-0.5, 0});
  game.run(path_m / 0.5, noise_m);
  game.drive(kWest0, {0, 0});
  game.drive(kEast0, {0.5, 0});
  game.run(1, noise_m);
  return game;
}

TEST(Pushing, IsCalledForPushingAnOpponentMoreThanTwoHundredMillimetres) {
  const DrivenGame game = push("2014", 0.225);
  ASSERT_EQ(game.calls(Event::kBotPushedBot).size(), 1U);
  const Decision call = game.calls(Event::kBotPushedBot).front();
  EXPECT_EQ(call.finding.offender, Side::kEast);
  EXPECT_EQ(call.finding.robots.front(), kEast0);
  EXPECT_EQ(call.finding.robots.back(), kWest0);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kDirectFree, Side::kWest}));
  EXPECT_GT(call.finding.value, 0.2);
  EXPECT_LT(call.finding.value, 0.21);
}

TEST(Pushing, IsNotCalledUpToTwoHundredMillimetres) {
  EXPECT_TRUE(push("2014", 0.175).calls(Event::kBotPushedBot).empty());
}

TEST(Pushing, IsNotCalledIfTheOpponentDrivesAwayItself) {
  EXPECT_TRUE(push("2014", 0.4, 0.3).calls(Event::kBotPushedBot).empty());
}

// The pusher slides round the opponent, so that the opponent's former motion is across their line.
TEST(Pushing, IsNotCalledLaterInTheContactIfTheOpponentDroveAwayItself) {
  DrivenGame game(by_book("2014"));
  game.put(kWest0, {0.39, -0.8}, {-0.3, 0});
  game.put(kEast0, {0.63, -0.8}, {-0.5, 0});
  game.run(0.3);
  game.drive(kWest0, {-0.5, 0});
  game.run(0.5);
  const Vec2 west_m{0.05, -0.8};
  game.put(kWest0, west_m, {0, 0});
  for (int step = 1; step <= 18; ++step) {
    game.put(kEast0, west_m + 0.18 * heading_of(step * 3.14159265 / 36), {0, 0});
    game.run(0.0167);
  }
  game.drive(kWest0, {0, -0.5});
  game.drive(kEast0, {0, -0.5});
  game.run(0.6);
  EXPECT_TRUE(game.calls(Event::kBotPushedBot).empty());
}

TEST(Pushing, EndsWhenTheRobotsSeparate) {
  DrivenGame game(by_book("2014"));
  game.put(kWest0, {0.3, -0.8}, {0, 0});
  game.put(kEast0, {0.3 + 0.181, -0.8}, {0, 0});
  for (int i = 0; i < 3; ++i) {
    game.run(0.1);
    game.drive(kWest0, {-0.5, 0});
    game.drive(kEast0, {-0.5, 0});
    game.run(0.3);
    game.drive(kWest0, {0, 0});
    game.drive(kEast0, {0.3, 0});
    game.run(0.1);
    game.drive(kEast0, {-0.3, 0});
    game.run(0.1);
    game.drive(kEast0, {0, 0});
  }
  EXPECT_TRUE(game.calls(Event::kBotPushedBot).empty());
}

TEST(Pushing, IsTheSameUnderNoise) {
  EXPECT_EQ(push("2014", 0.225, 0, 0.0013).calls(Event::kBotPushedBot).size(), 1U);
  EXPECT_TRUE(push("2014", 0.175, 0, 0.0013).calls(Event::kBotPushedBot).empty());
}

TEST(Pushing, InsideTheOffendersOwnAreaIsAPenaltyKickByTheLaws) {
  DrivenGame game(by_book("2014"));
  game.put(kWest0, {2.5, 0.3}, {0, 0});
  game.put(kEast0, {2.5 + 0.18, 0.3}, {0, 0});
  game.run(0.2);
  game.drive(kWest0, {-0.5, 0});
  game.drive(kEast0, {-0.5, 0});
  game.run(0.5);
  ASSERT_EQ(game.calls(Event::kBotPushedBot).size(), 1U);
  EXPECT_EQ(game.calls(Event::kBotPushedBot).front().restart(),
            (Command{CommandKind::kPreparePenalty, Side::kWest}));
}

TEST(Pushing, StopsPlayIn2026AndIsNotAFoulInThePaper) {
  EXPECT_EQ(push("2026-b", 0.225).calls(Event::kBotPushedBot).size(), 1U);
  EXPECT_TRUE(push("paper", 0.4).calls(Event::kBotPushedBot).empty());
}

}  // namespace
}  // namespace autoref::referee
