// Offences while play is stopped, and the number of robots allowed, under the 2026 rules
// ("Offenses", "Scoring Goals"), in staged worlds.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr const char* kTooFastInStop = "bot_too_fast_in_stop";
constexpr const char* kInterference = "bot_interfered_placement";

// Drives these west robots at this speed for 0.2 s.
void drive_west(StagedGame& game, const std::vector<RobotId>& ids, double speed_mps = 1.8) {
  for (int frame = 0; frame < 12; ++frame) {
    for (const RobotId id : ids) {
      game.world.put_robot(id, {-2.0 + 0.03 * frame, -1.8 + 0.3 * id.number}, {1, 0},
                           {speed_mps, 0});
    }
    game.frames(1);
  }
}

TEST(Truth2026, SeveralRobotsTooFastInStopWithinTwoSecondsAreOneFoul) {
  StagedGame game(book("2026-b"));
  game.seconds(2.5);
  drive_west(game, {kWest0, kWest1});
  EXPECT_EQ(game.times_s(kTooFastInStop).size(), 1U);
  game.seconds(1.0);
  drive_west(game, {kWest0, kWest1});
  EXPECT_EQ(game.times_s(kTooFastInStop).size(), 1U);
  game.seconds(1.0);
  drive_west(game, {kWest0, kWest1});  // the other robot
  EXPECT_EQ(game.times_s(kTooFastInStop).size(), 2U);
}

TEST(Truth2026, ARobotIsTooFastOncePerStopEvenIfStopIsRepeated) {
  StagedGame game(book("2026-b"));
  game.seconds(2.5);
  drive_west(game, {kWest1});
  game.command(CommandKind::kStop);
  game.seconds(2.5);
  drive_west(game, {kWest1});
  EXPECT_EQ(game.times_s(kTooFastInStop).size(), 1U);
}

TEST(Truth2026, NoRobotIsTooFastWhileTheBallIsBeingPlaced) {
  for (const double ball_x_m : {-1.0, 1.0}) {
    StagedGame game(book("2026-b"));
    game.world.put_ball({ball_x_m, 0});
    game.signal.placement = Placement{{1, 0}, false};
    game.seconds(2.5);
    drive_west(game, {kWest1});
    EXPECT_EQ(game.has(kTooFastInStop), ball_x_m == 1.0) << ball_x_m;
  }
}

TEST(Truth2026, TooFastInStopStartsAtOneAndAHalfMetresPerSecond) {
  for (const double speed_mps : {1.4, 1.6}) {
    StagedGame game(book("2026-b"));
    game.seconds(2.5);
    drive_west(game, {kWest1}, speed_mps);
    EXPECT_EQ(game.has(kTooFastInStop), speed_mps > 1.5) << speed_mps;
  }
}

TEST(Truth2026, PlacementInterferenceIsCountedOncePerPlacement) {
  StagedGame game(book("2026-b"));
  game.signal.placement = Placement{{1, 0}, false};
  game.signal.next_command = Command{CommandKind::kDirectFree, Side::kWest};
  game.world.put_ball({-1, 0});
  game.world.put_robot(kEast0, {0.4, 0.5}, {-1, 0});
  game.world.put_robot(kEast1, {0, 0.5}, {-1, 0});
  game.seconds(6.0);
  EXPECT_EQ(game.times_s(kInterference).size(), 1U);
  game.signal.placement = Placement{{1, 0.1}, false};
  game.seconds(2.3);
  EXPECT_EQ(game.times_s(kInterference).size(), 2U);
}

// "Only one interference foul per ball placement phase counts towards the foul counter, but the
// placement timer is always incremented."
TEST(Truth2026, InterferenceWithATeamsPlacementIsRaisedAgainButCountedOnce) {
  StagedGame game(book("2026-b"));
  game.world.put_ball({-1, 0});
  game.world.put_robot(kEast1, {0, 0.5}, {-1, 0});
  game.signal.placement = Placement{{1, 0}, false, false};
  game.signal.next_command = Command{CommandKind::kDirectFree, Side::kWest};
  game.seconds(3.0);  // nobody places the ball yet
  EXPECT_FALSE(game.has(kInterference));
  game.command(CommandKind::kBallPlacement, Side::kWest);
  game.seconds(9.0);
  const std::vector<double> times_s = game.times_s(kInterference);
  ASSERT_EQ(times_s.size(), 4U);
  EXPECT_NEAR(times_s[1] - times_s[0], 2.0, 0.02);
  EXPECT_FALSE(game.has("multiple_fouls"));
}

TEST(Truth2026, TheTeamThatPlacesTheBallDoesNotInterfere) {
  StagedGame game(book("2026-b"));
  game.world.put_ball({-1, 0});
  game.world.put_robot(kEast1, {0, 0.5}, {-1, 0});
  game.signal.placement = Placement{{1, 0}, false, false};
  game.signal.next_command = Command{CommandKind::kForceStart};
  game.command(CommandKind::kBallPlacement, Side::kEast);
  game.seconds(3.0);
  EXPECT_FALSE(game.has(kInterference));
}

// "The referee has to place the ball for all kickoffs and all penalty kicks": no team places it.
TEST(Truth2026, NobodyInterferesWithTheBallOfAKickOffOrPenaltyKick) {
  for (const CommandKind next : {CommandKind::kPrepareKickoff, CommandKind::kPreparePenalty}) {
    StagedGame game(book("2026-b"));
    game.signal.placement = Placement{{1, 0}, false};
    game.signal.next_command = Command{next, Side::kWest};
    game.world.put_ball({-1, 0});
    game.world.put_robot(kEast1, {0, 0.5}, {-1, 0});
    game.seconds(3.0);
    EXPECT_FALSE(game.has(kInterference)) << name_of(next);
  }
}

// West may have one robot and has two; the second one starts outside the field lines.
struct Surplus : StagedGame {
  Surplus() : StagedGame(book("2026-b")) {
    world.put_robot(kWest1, {-1.0, -2.3});
    world.put_ball({0, 1.0});
    signal.robots_allowed[Side::kWest] = 1;
  }
  void come_back() { world.put_robot(kWest1, {-1.0, -1.5}); }
};

TEST(Truth2026, TooManyRobotsIsCalledTwoSecondsAfterAStart) {
  Surplus game;
  game.seconds(15.0);
  game.command(CommandKind::kForceStart);
  game.come_back();
  game.seconds(1.9);
  EXPECT_FALSE(game.has("too_many_robots"));
  game.seconds(0.2);
  EXPECT_TRUE(game.has("too_many_robots"));
}

TEST(Truth2026, TooManyRobotsAreToleratedForTenSecondsAfterACard) {
  Surplus game;
  game.come_back();
  game.seconds(9.9);
  EXPECT_FALSE(game.has("too_many_robots"));
  game.seconds(0.3);
  ASSERT_TRUE(game.has("too_many_robots"));
  EXPECT_NEAR(game.first("too_many_robots").time_s, 10.0, 0.02);
}

TEST(Truth2026, EachCardGivesItsRobotTenSeconds) {
  Surplus game;
  game.come_back();
  game.seconds(5.0);
  game.signal.robots_allowed[Side::kWest] = 0;
  game.seconds(4.0);
  game.world.put_robot(kWest1, {-1.0, -2.3});  // leaves the field for the first card
  game.seconds(5.9);
  EXPECT_FALSE(game.has("too_many_robots"));
  game.seconds(0.3);
  EXPECT_TRUE(game.has("too_many_robots"));
}

}  // namespace
}  // namespace autoref::judge::ground_truth
