// True events that concern robots, in staged worlds.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

TEST(TrueAreaTouch, IsThatOfADefenderOtherThanTheKeeper) {
  for (const RobotId id : {kWest0, kWest1}) {
    StagedGame game;
    game.world.put_robot(id, {-2.7, 0.3});
    game.world.put_ball({-2.4, 0.3}, {-3.0, 0});
    game.command(CommandKind::kForceStart);
    game.seconds(0.3);
    EXPECT_EQ(game.has("defender_in_defense_area"), id == kWest1) << id.number;
  }
}

// The area's front line is 0.8 m from the goal line at 3.025 m.
TEST(TrueAreaTouch, IsPartialIfTheHullIsOnTheLine) {
  StagedGame game;
  game.world.put_robot(kWest1, {-2.225, 0});
  game.world.put_ball({-1.9, 0}, {-3.0, 0});
  game.command(CommandKind::kForceStart);
  game.seconds(0.2);
  EXPECT_TRUE(game.has("defender_in_defense_area_partially"));
  EXPECT_FALSE(game.has("defender_in_defense_area"));
}

TEST(TrueAreaTouch, IsThatOfAnAttackerByTheRulesOf2026) {
  StagedGame game(book("2026-b"));
  game.world.put_robot(kEast1, {-2.7, 0.3}, {1, 0});
  game.world.put_ball({-2.4, 0.3}, {-3.0, 0});
  game.command(CommandKind::kForceStart);
  game.seconds(0.3);
  EXPECT_TRUE(game.has("attacker_touched_ball_in_defense_area"));
}

// No rule book excuses a defender that has met an opponent on its way into the area.
TEST(TrueAreaTouch, IsNotExcusedByAnOpponentInContact) {
  StagedGame game(book("2026-b"));
  game.world.put_robot(kEast1, {-2.1, 0.3}, {-1, 0});
  game.world.put_robot(kWest1, {-2.282, 0.3}, {-1, 0});
  game.world.put_ball({0, 0});
  game.command(CommandKind::kForceStart);
  game.frames(1);
  game.world.put_robot(kEast1, {0, -1.5}, {-1, 0});
  game.world.put_robot(kWest1, {-2.7, 0.3}, {1, 0});
  game.world.put_ball({-2.4, 0.3}, {-3.0, 0});
  game.seconds(0.3);
  EXPECT_TRUE(game.has("defender_in_defense_area"));
}

// Both robots drive without commands, but for such a short time that they hardly brake.
void stage_crash(StagedGame& game, double west_mps, double east_mps) {
  game.world.put_ball({0, 1});
  game.command(CommandKind::kForceStart);
  game.world.put_robot(kWest1, {-0.093, 0}, {1, 0}, {west_mps, 0});
  game.world.put_robot(kEast1, {0.093, 0}, {-1, 0}, {-east_mps, 0});
  game.frames(3);
}

TEST(TrueCrash, IsTheFasterRobotsFault) {
  StagedGame game;
  stage_crash(game, 0.5, 2.0);
  ASSERT_TRUE(game.has("bot_crash_unique"));
  EXPECT_EQ(game.first("bot_crash_unique").robot, kEast1);
}

TEST(TrueCrash, NeedsEnoughSpeed) {
  StagedGame game;
  stage_crash(game, 0.2, 1.0);
  EXPECT_FALSE(game.has("bot_crash_unique"));
}

TEST(TrueCrash, IsDrawnIfBothAreEquallyFast) {
  StagedGame game(book("2026-b"));
  stage_crash(game, 1.2, 1.2);
  EXPECT_TRUE(game.has("bot_crash_drawn"));
  EXPECT_FALSE(game.has("bot_crash_unique"));
}

// Crashes happen "always" (2026, appendix C); Laws 2014 list them among the fouls of play.
TEST(TrueCrash, CountsInAStopOnlyByTheRulesOf2026) {
  for (const char* rules : {"2014", "2026-b"}) {
    StagedGame game(book(rules));
    game.world.put_ball({0, 1});
    game.world.put_robot(kWest1, {-0.093, 0}, {1, 0}, {0.5, 0});
    game.world.put_robot(kEast1, {0.093, 0}, {-1, 0}, {-2.0, 0});
    game.frames(3);
    EXPECT_EQ(game.has("bot_crash_unique"), book(rules).edition == Edition::kRules2026) << rules;
  }
}

TEST(TruePushing, RequiresTwentyCentimetresInContact) {
  StagedGame game;
  game.world.put_ball({0, 1});
  game.world.put_robot(kWest1, {-0.2, 0});
  game.world.put_robot(kEast1, {0, 0}, {-1, 0});
  game.command(CommandKind::kForceStart);
  for (int frame = 0; frame < 60; ++frame) {
    const double x_m = 0.005 * frame;
    game.world.put_robot(kWest1, {x_m - 0.182, 0});
    game.world.put_robot(kEast1, {x_m, 0}, {-1, 0});
    game.frames(1);
  }
  ASSERT_TRUE(game.has("bot_pushed_bot"));
  EXPECT_EQ(game.first("bot_pushed_bot").robot, kWest1);
}

TEST(TrueStopSpeed, IsTooFastAfterTheGracePeriod) {
  StagedGame game;
  game.world.command(kWest1).velocity_mps = {1.4, 0};
  game.seconds(1.9);
  EXPECT_FALSE(game.has("bot_too_fast_in_stop"));
  game.world.put_robot(kWest1, {-2.0, -1.9}, {1, 0}, {1.4, 0});
  game.seconds(0.6);
  ASSERT_TRUE(game.has("bot_too_fast_in_stop"));
  EXPECT_EQ(game.first("bot_too_fast_in_stop").robot, kWest1);
}

TEST(TrueStopDistance, IsMeasuredOnceTheBallIsPlaced) {
  StagedGame game;
  game.signal.placement = Placement{{0, 0}, false};
  game.world.put_ball({0, 0});
  game.world.put_robot(kEast1, {0.4, 0}, {-1, 0});
  game.seconds(1.5);
  EXPECT_FALSE(game.has("stop_distance"));
  game.seconds(1.0);
  EXPECT_TRUE(game.has("stop_distance"));
}

TEST(TrueStopDistance, IsFromTheHullToTheBallsCentre) {
  for (const double gap_m : {0.49, 0.51}) {
    StagedGame game;
    game.signal.placement = Placement{{0, 0}, false};
    game.world.put_ball({0, 0});
    game.world.put_robot(kEast1, {gap_m + kRobotRadius_m, 0}, {1, 0});
    game.seconds(2.5);
    EXPECT_EQ(game.has("stop_distance"), gap_m < 0.5) << gap_m;
  }
}

// West kicks the ball away to take a restart.
void take_restart(StagedGame& game, CommandKind kind) {
  game.command(kind, Side::kWest);
  if (kind == CommandKind::kPrepareKickoff) game.command(CommandKind::kNormalStart);
  game.frames(1);
  game.world.put_ball(game.world.ball().position_m + Vec2(0, 0.06));
  game.frames(1);
}

TEST(TrueRestart, IsWrongWithAnOpponentTooCloseToTheBall) {
  for (const double gap_m : {0.45, 0.55}) {
    StagedGame game;
    game.world.put_ball({0, 0});
    game.world.put_robot(kEast1, {gap_m + 0.075, 0}, {-1, 0});
    take_restart(game, CommandKind::kDirectFree);
    EXPECT_EQ(game.has("defender_too_close_to_kick_point"), gap_m < 0.5) << gap_m;
  }
}

TEST(TrueRestart, IsWrongWithAnAttackerTooCloseToTheArea) {
  for (const double gap_m : {0.15, 0.25}) {
    StagedGame game;
    game.world.put_ball({0, 1});
    game.world.put_robot(kWest1, {3.025 - 0.8 - gap_m - 0.075, 0});
    take_restart(game, CommandKind::kDirectFree);
    EXPECT_EQ(game.has("attacker_too_close_to_defense_area"), gap_m < 0.2) << gap_m;
  }
}

// "A member of the kicker's team" (Laws 2014, law 9); the paper says "each robot".
TEST(TrueRestart, IsWrongWithAnOpponentNearTheKickersAreaOnlyByThePaper) {
  for (const char* rules : {"paper", "2014"}) {
    StagedGame game(book(rules));
    game.world.put_ball({0, 1});
    game.world.put_robot(kEast1, {-3.025 + 0.8 + 0.15 + 0.09, 0});
    take_restart(game, CommandKind::kDirectFree);
    EXPECT_EQ(game.has("attacker_too_close_to_defense_area"),
              book(rules).edition == Edition::kPaper)
        << rules;
  }
}

TEST(TrueRestart, IsWrongWithARobotInTheOtherHalfAtKickOff) {
  StagedGame game;
  game.world.put_ball({0, 0});
  game.world.put_robot(kEast1, {-0.5, 1}, {-1, 0});
  take_restart(game, CommandKind::kPrepareKickoff);
  EXPECT_TRUE(game.has("kickoff_positions"));
}

TEST(TrueRestart, IsRetakenAtMostThreeTimes) {
  StagedGame game;
  game.world.put_robot(kEast1, {-0.5, 1}, {-1, 0});
  for (int kickoff = 0; kickoff < 5; ++kickoff) {
    game.command(CommandKind::kStop);
    game.world.put_ball({0, 0});
    game.frames(1);
    take_restart(game, CommandKind::kPrepareKickoff);
    EXPECT_EQ(game.names().size(), kickoff < 3 ? kickoff + 1U : kickoff == 3 ? 3U : 4U) << kickoff;
  }
}

TEST(TrueRestart, IsNotTakenAfterTenSeconds) {
  StagedGame game;
  game.world.put_ball({0, 1});
  game.command(CommandKind::kIndirectFree, Side::kEast);
  game.seconds(9.8);
  EXPECT_FALSE(game.has("restart_not_taken"));
  game.seconds(0.4);
  ASSERT_TRUE(game.has("restart_not_taken"));
  EXPECT_EQ(game.first("restart_not_taken").offender, Side::kEast);
}

TEST(TrueGraceTimer, ReportsInterferenceNearThePlacementLane) {
  StagedGame game(book("2026-b"));
  game.signal.placement = Placement{{1, 0}, false};
  game.signal.next_command = Command{CommandKind::kDirectFree, Side::kWest};
  game.world.put_ball({-1, 0});
  game.world.put_robot(kEast1, {0, 0.5}, {-1, 0});
  game.seconds(2.3);
  EXPECT_TRUE(game.has("bot_interfered_placement"));
}

}  // namespace
}  // namespace autoref::judge::ground_truth
