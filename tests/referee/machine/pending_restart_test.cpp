// A kick-off or penalty kick that is about to be taken stays the restart, whatever foul is called
// in the stop (the league's game controller).
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

constexpr Command kKickoffWest{CommandKind::kPrepareKickoff, Side::kWest};
constexpr Command kPenaltyEast{CommandKind::kPreparePenalty, Side::kEast};

void expect_pending(const ScriptedGame& game, const Command& restart, const Vec2& position_m) {
  EXPECT_EQ(game.decisions.back().restart(), restart);
  EXPECT_EQ(game.signal.next_command, restart);
  ASSERT_TRUE(game.signal.placement);
  EXPECT_EQ(game.signal.placement->target_m, position_m);
}

// Play goes on with this restart once the ball is placed.
void expect_taken(ScriptedGame& game, const Command& restart) {
  game.placement_works = true;
  Command before = game.signal.command;
  while (game.signal.command.kind != CommandKind::kNormalStart && game.now_s() < 120) {
    before = game.signal.command;
    game.step();
  }
  EXPECT_EQ(game.signal.command.kind, CommandKind::kNormalStart);
  EXPECT_EQ(before, restart);
}

// Yellow's kick-off is to be retaken, and the ball flies on.
ScriptedGame retaken_kickoff() {
  ScriptedGame game(by_book("2026-b"));
  game.line_up().kick_off();
  game.placement_works = false;
  game.robot(Side::kWest, 2) = {2, {0.5, 1.2}, Vec2(0, 1)};
  game.kick(Side::kWest, 1, {0, 6});
  game.run_until("kickoff_positions", 1);
  return game;
}

// Blue gets a penalty kick because yellow 1 kicks from its own area, and the ball flies on.
ScriptedGame penalty_for_blue() {
  ScriptedGame game = in_play(by_book("2026-b"));
  game.placement_works = false;
  game.kick_from(Side::kWest, 1, {-4, 0}, {0, 6});
  game.run_until("defender_in_defense_area", 1);
  return game;
}

TEST(PendingKickoff, StaysAfterABoundaryCrossing) {
  ScriptedGame game = retaken_kickoff();
  game.run_until("boundary_crossing", 2);
  expect_pending(game, kKickoffWest, {0, 0});
  expect_taken(game, kKickoffWest);
}

TEST(PendingPenaltyKick, StaysAfterABoundaryCrossing) {
  ScriptedGame game = penalty_for_blue();
  const Vec2 mark_m = game.signal.placement->target_m;
  game.run_until("boundary_crossing", 2);
  expect_pending(game, kPenaltyEast, mark_m);
  expect_taken(game, kPenaltyEast);
}

// Attackers near the area are not judged before a kick-off.
TEST(PendingPenaltyKick, StaysWhenAttackersStayNearTheArea) {
  ScriptedGame game = penalty_for_blue();
  const Vec2 mark_m = game.signal.placement->target_m;
  game.put_ball({1, 1});
  game.robot(Side::kWest, 2).position_m = {3.3, 0};
  game.run_until("attacker_stays_near_area", 4);
  expect_pending(game, kPenaltyEast, mark_m);
  EXPECT_EQ(game.signal.command.kind, CommandKind::kStop);
  game.run_until("attacker_stays_near_area", 4);
  expect_pending(game, kPenaltyEast, mark_m);
  EXPECT_EQ(game.signal.command.kind, CommandKind::kHalt);
  game.robot(Side::kWest, 2).position_m = {0.5, 0};
  expect_taken(game, kPenaltyEast);
}

}  // namespace
}  // namespace autoref::referee
