// "All robots are in their own half of the field" (Laws 8); the kicker may leave it within the
// centre circle. Otherwise the kick-off is retaken.
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

class KickoffPositions : public testing::TestWithParam<const char*> {
 protected:
  // A kick-off by west, until a few frames after the kick, with one robot at `position_m`.
  ScriptedGame kicked_off(Side side, int number, const Vec2& position_m) {
    ScriptedGame game(by_book(GetParam()));
    game.line_up().kick_off();
    game.robot(side, number) = {number, position_m, Vec2(0, 1)};
    game.kick(Side::kWest, 1, {1, 0});
    game.run(0.3);
    return game;
  }
};

INSTANTIATE_TEST_SUITE_P(Books, KickoffPositions, testing::Values("2014", "2026-b"),
                         [](const auto& book) {
                           std::string name = book.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(KickoffPositions, TheKickOffIsRetakenIfARobotIsEntirelyInTheOpponentsHalf) {
  for (const Side side : kSides) {
    const ScriptedGame game = kicked_off(side, 2, {-goal_sign(side) * 0.095, 1.2});
    ASSERT_EQ(game.count("kickoff_positions"), 1);
    const Decision& again = game.decisions.back();
    EXPECT_TRUE(is_foul_of(again, {side, 2}));
    EXPECT_NEAR(again.finding.value, 0.005, 1e-9);
    EXPECT_EQ(again.restart(), (Command{CommandKind::kPrepareKickoff, Side::kWest}));
    EXPECT_EQ(game.signal.placement->target_m, Vec2(0, 0));
  }
}

TEST_P(KickoffPositions, ARobotMayBePartlyInItsOwnHalf) {
  const ScriptedGame game = kicked_off(Side::kEast, 2, {-0.085, 1.2});
  EXPECT_EQ(game.count("kickoff_positions"), 0);
}

TEST_P(KickoffPositions, TheKickerMayLeaveItsHalfInTheCircle) {
  ScriptedGame game(by_book(GetParam()));
  game.line_up().kick_off();
  game.kick(Side::kWest, 1, {-1, 0});  // from beyond the ball
  game.run(0.3);
  EXPECT_TRUE(game.referee.is_ball_in_play());
  EXPECT_EQ(game.count("kickoff_positions"), 0);
}

TEST_P(KickoffPositions, AnotherRobotOfTheKickersSideMayNotLeaveItsHalf) {
  ScriptedGame game(by_book(GetParam()));
  game.line_up().kick_off();
  game.robot(Side::kWest, 2) = {2, {0.3, 0.3}, Vec2(0, 1)};
  game.kick(Side::kWest, 1, {-1, 0});
  game.run(0.3);
  EXPECT_EQ(game.count("kickoff_positions"), 1);
}

TEST_P(KickoffPositions, IfBothSidesAreWrongNeitherIsTheOffender) {
  ScriptedGame game(by_book(GetParam()));
  game.line_up().kick_off();
  game.robot(Side::kWest, 2) = {2, {1, 1.2}, Vec2(0, 1)};
  game.robot(Side::kEast, 2) = {2, {-1, 1.2}, Vec2(0, 1)};
  game.kick(Side::kWest, 1, {1, 0});
  EXPECT_FALSE(game.run_until("kickoff_positions", 1).finding.offender.has_value());
}

TEST(KickoffPositionsRule, AppliesOnlyToKickOffs) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  game.robot(Side::kEast, 4).position_m = Vec2(-1.5, 0);
  game.kick(Side::kEast, 3, {-1, 0});
  game.run(1);
  EXPECT_EQ(game.count("kickoff_positions"), 0);
}

}  // namespace
}  // namespace autoref::referee
