// Robots too close until a restart is taken, under the 2026 rules ("Offenses"), in staged worlds.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr const char* kTooCloseToBall = "defender_too_close_to_kick_point";
constexpr const char* kTooCloseToArea = "attacker_stays_near_area";
constexpr double kToAFrame_s = 0.02;

// West's free kick at (0, 1), with an opponent 0.2 m from the ball.
struct CrowdedFreeKick : StagedGame {
  CrowdedFreeKick() : StagedGame(book("2026-b")) {
    world.put_ball({0, 1});
    world.put_robot(kEast1, {0.3, 1}, {-1, 0});
    command(CommandKind::kDirectFree, Side::kWest);
  }
};

// Puts a west robot 0.15 m from east's area, which is 0.8 m deep from the line at 3.025 m.
void put_near_area(StagedGame& game, RobotId id, double y_m = 0) {
  game.world.put_robot(id, {3.025 - 0.8 - 0.15 - 0.09, y_m}, {-1, 0});
}

TEST(Truth2026, TooCloseToTheKickPointCountsAtOnce) {
  CrowdedFreeKick game;
  game.frames(1);
  ASSERT_EQ(game.names(), std::vector<std::string>{kTooCloseToBall});
  EXPECT_EQ(game.first(kTooCloseToBall).offender, Side::kEast);
}

TEST(Truth2026, TooCloseToTheKickPointIsRaisedAgainEveryTwoSeconds) {
  CrowdedFreeKick game;
  game.seconds(5.0);
  const std::vector<double> times_s = game.times_s(kTooCloseToBall);
  ASSERT_EQ(times_s.size(), 3U);
  EXPECT_NEAR(times_s[1] - times_s[0], 2.0, kToAFrame_s);
  EXPECT_NEAR(times_s[2] - times_s[1], 2.0, kToAFrame_s);
}

TEST(Truth2026, SeveralRobotsTooCloseToTheKickPointAreOneFoul) {
  CrowdedFreeKick game;
  game.frames(30);
  game.world.put_robot(kEast0, {0, 1.3}, {0, -1});
  game.frames(60);
  EXPECT_EQ(game.times_s(kTooCloseToBall).size(), 1U);
}

TEST(Truth2026, TheGracePeriodAtTheKickPointOutlastsTheRestart) {
  CrowdedFreeKick game;
  game.seconds(0.5);
  game.command(CommandKind::kStop);
  game.seconds(0.5);
  game.command(CommandKind::kDirectFree, Side::kWest);
  game.seconds(0.9);
  EXPECT_EQ(game.times_s(kTooCloseToBall).size(), 1U);
  game.seconds(0.3);
  EXPECT_EQ(game.times_s(kTooCloseToBall).size(), 2U);
}

TEST(Truth2026, TooCloseToTheKickPointResetsTheKickersTime) {
  CrowdedFreeKick game;
  game.seconds(5.0);  // the last of three fouls happens after 4 s
  game.world.put_robot(kEast1, {1.0, -1.9}, {-1, 0});
  game.seconds(8.8);
  EXPECT_FALSE(game.has("restart_not_taken"));
  game.seconds(0.4);
  EXPECT_TRUE(game.has("restart_not_taken"));
}

TEST(Truth2026, TooCloseToTheAreaHasTwoSecondsFromTheStop) {
  StagedGame game(book("2026-b"));
  put_near_area(game, kWest1);
  game.seconds(1.9);
  EXPECT_FALSE(game.has(kTooCloseToArea));
  game.seconds(0.2);
  EXPECT_TRUE(game.has(kTooCloseToArea));
}

TEST(Truth2026, TooCloseToTheAreaCountsAtOnceAfterTheGracePeriod) {
  StagedGame game(book("2026-b"));
  game.seconds(3.0);
  put_near_area(game, kWest1);
  game.frames(1);
  EXPECT_TRUE(game.has(kTooCloseToArea));
}

TEST(Truth2026, TooCloseToTheAreaCountsPerTeamNotPerRobot) {
  StagedGame game(book("2026-b"));
  put_near_area(game, kWest0, -0.1);
  put_near_area(game, kWest1, 0.1);
  game.seconds(3.8);
  EXPECT_EQ(game.times_s(kTooCloseToArea).size(), 1U);
}

// The second foul halts the game.
TEST(Truth2026, TooCloseToTheAreaIsRaisedTwiceInAStopTwoSecondsApart) {
  StagedGame game(book("2026-b"));
  put_near_area(game, kWest1);
  game.seconds(9.0);
  const std::vector<double> times_s = game.times_s(kTooCloseToArea);
  ASSERT_EQ(times_s.size(), 2U);
  EXPECT_NEAR(times_s[0], 2.0, kToAFrame_s);
  EXPECT_NEAR(times_s[1], 4.0, kToAFrame_s);
}

TEST(Truth2026, TooCloseToTheAreaContinuesFromTheStopIntoTheFreeKick) {
  StagedGame game(book("2026-b"));
  put_near_area(game, kWest1);
  game.seconds(1.5);
  game.command(CommandKind::kDirectFree, Side::kEast);
  game.seconds(0.4);
  EXPECT_FALSE(game.has(kTooCloseToArea));
  game.seconds(2.8);
  EXPECT_EQ(game.times_s(kTooCloseToArea).size(), 2U);
  game.command(CommandKind::kStop);
  game.seconds(1.8);
  EXPECT_EQ(game.times_s(kTooCloseToArea).size(), 2U);
  game.seconds(0.4);
  EXPECT_EQ(game.times_s(kTooCloseToArea).size(), 3U);
}

TEST(Truth2026, ARepeatedStopGivesNoNewGracePeriod) {
  StagedGame game(book("2026-b"));
  put_near_area(game, kWest1);
  game.seconds(1.5);
  game.command(CommandKind::kStop);
  game.seconds(0.6);
  EXPECT_TRUE(game.has(kTooCloseToArea));
}

TEST(Truth2026, EveryThirdFoulIsAYellowCard) {
  CrowdedFreeKick game;
  game.seconds(3.9);
  EXPECT_FALSE(game.has("multiple_fouls"));
  game.seconds(0.2);
  ASSERT_TRUE(game.has("multiple_fouls"));
  EXPECT_EQ(game.first("multiple_fouls").offender, Side::kEast);
  game.signal.yellow_cards[Side::kEast] = 1;
  game.seconds(6.2);  // fouls happen after 6, 8 and 10 s
  EXPECT_EQ(game.times_s("multiple_fouls").size(), 2U);
}

TEST(Truth2026, TheThirdActiveYellowCardIsARedCard) {
  CrowdedFreeKick game;
  game.seconds(0.1);
  game.signal.yellow_cards[Side::kEast] = 2;
  game.signal.robots_allowed[Side::kEast] -= 2;
  game.seconds(7);
  EXPECT_FALSE(game.has("multiple_fouls"));
  ASSERT_TRUE(game.has("multiple_cards"));
  EXPECT_EQ(game.first("multiple_cards").offender, Side::kEast);
}

// The card is judged separately; the fouls for later cards are counted from this card on.
TEST(Truth2026, ACardThatIsNotDueRestartsTheCount) {
  CrowdedFreeKick game;
  game.seconds(3.0);  // two fouls
  game.signal.yellow_cards[Side::kEast] = 1;
  game.seconds(4.5);
  EXPECT_FALSE(game.has("multiple_fouls"));
  game.seconds(1.0);
  EXPECT_TRUE(game.has("multiple_fouls"));
}

}  // namespace
}  // namespace autoref::judge::ground_truth
