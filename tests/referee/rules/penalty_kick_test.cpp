// Penalty kicks from the whistle to the outcome (Laws 14; 2026, Penalty Kick), for either side.
#include <gtest/gtest.h>

#include "tests/referee/machine/penalty_game.hpp"

namespace autoref::referee {
namespace {

const Vec2 kPastTheKeeper_mps(4, 1.0);  // scores from the 0.75 m mark of either book
const Vec2 kPastTheGoal_mps(3, 3);

class PenaltyKick : public testing::TestWithParam<Side> {
 protected:
  Side kicker() const { return GetParam(); }
  Side defender() const { return opponent_of(kicker()); }
};

INSTANTIATE_TEST_SUITE_P(Sides, PenaltyKick, testing::ValuesIn(kSides),
                         [](const auto& side) { return std::string(name_of(side.param)); });

TEST_P(PenaltyKick, IsPreparedAtTheMarkStartedAndScored) {
  PenaltyGame game("2014", kicker());
  game.run_until("prepare");
  EXPECT_EQ(game.state.signal.command, (Command{CommandKind::kPreparePenalty, kicker()}));
  EXPECT_NEAR((game.state.signal.placement->target_m - game.at({3.025 - 0.75, 0})).norm(), 0,
              1e-12);
  game.whistle();
  EXPECT_EQ(game.state.signal.command.kind, CommandKind::kNormalStart);
  game.kick(kPastTheKeeper_mps);
  game.run_until("goal", 2);
  EXPECT_EQ(game.state.signal.goals[kicker()], 1);
  EXPECT_EQ(game.state.signal.next_command, (Command{CommandKind::kPrepareKickoff, defender()}));
}

TEST_P(PenaltyKick, ThatIsSavedDoesNotStopPlayByTheLaws) {
  PenaltyGame game("2014", kicker());
  game.put(defender(), 0, {3.025 - 0.05, 0});
  game.whistle().kick({3, 0});
  game.save({-1, 0.3});
  game.run(2);
  EXPECT_EQ(game.state.machine_state, State::kRun);
  EXPECT_EQ(game.transitions.back(), "start");
}

TEST_P(PenaltyKick, ThatIsNotTakenLeadsToANeutralRestartByTheLaws) {
  PenaltyGame game("2014", kicker());
  const double since_s = game.whistle().now_s();
  const Finding untaken = game.run_until("restart_not_taken");
  EXPECT_NEAR(game.now_s() - since_s, 10, 1e-6);
  EXPECT_EQ(untaken.restart.kind, CommandKind::kForceStart);
  EXPECT_GE(distance_to_defence_area(game.field(), defender(), untaken.ball_to_m), 0.7 - 1e-9);
}

// "penalty failed: 10 s" (2026)
TEST_P(PenaltyKick, HasFailedAfterTenSecondsIn2026) {
  PenaltyGame game("2026-b", kicker());
  const double since_s = game.whistle().now_s();
  const Finding failed = game.run_until("penalty_kick_failed");
  EXPECT_NEAR(game.now_s() - since_s, 10, 1e-6);
  EXPECT_EQ(failed.restart, (Command{CommandKind::kDirectFree, defender()}));
  // Goal kick: 1 m from the goal line, 0.2 m from a touch line.
  EXPECT_NEAR(game.at(failed.ball_to_m).x(), 4.5 - 1, 1e-12);
  EXPECT_NEAR(std::abs(failed.ball_to_m.y()), 3 - 0.2, 1e-12);
}

TEST_P(PenaltyKick, HasFailedAfterTenSecondsIn2026IfTheBallIsNeverSeen) {
  PenaltyGame game("2026-b", kicker());
  game.hide_ball();
  game.run_until("start_late", 40);
  const double since_s = game.now_s();
  game.run_until("penalty_kick_failed");
  EXPECT_NEAR(game.now_s() - since_s, 10, 1e-6);
}

TEST_P(PenaltyKick, HasFailedIn2026WhenTheBallGoesOut) {
  PenaltyGame game("2026-b", kicker());
  game.whistle().kick({5.5, 2});
  EXPECT_EQ(game.run_until("penalty_kick_failed", 4).restart,
            (Command{CommandKind::kDirectFree, defender()}));
}

TEST_P(PenaltyKick, HasFailedIn2026WhenTheKeeperTurnsTheBallBack) {
  PenaltyGame game("2026-b", kicker());
  game.put(defender(), 0, {4.45, 0});
  game.whistle().kick({6, 0});
  game.run(0.7);
  game.save({-1, 0.5});
  const Finding failed = game.run_until("penalty_kick_failed", 2);
  EXPECT_EQ(failed.unit, "deg");
  EXPECT_NEAR(failed.value, 153, 5);
}

TEST_P(PenaltyKick, ContinuesIn2026WhenTheKeeperTurnsTheBallByLess) {
  PenaltyGame game("2026-b", kicker());
  game.put(defender(), 0, {4.45, 0});
  game.whistle().kick({6, 0});
  game.run(0.7);
  game.save({0.15, 0.8});  // by 79 degrees
  game.run(0.5);
  EXPECT_EQ(game.state.machine_state, State::kRun);
}

TEST_P(PenaltyKick, ThatScoresIsAGoalIn2026) {
  PenaltyGame game("2026-b", kicker());
  game.whistle().kick({6, 0.3});
  game.run_until("goal", 3);
  EXPECT_EQ(game.state.signal.goals[kicker()], 1);
}

// "behind a line parallel to the goal line and 400 mm behind the penalty mark"
// The kicker's robots face the goal with their plates, the defenders face away from it.
Vec2 behind_mark(const PenaltyGame& game, double gap_m, double reach_m = kRobotRadius_m) {
  return game.mark_m - Vec2(gap_m + reach_m, 0.8);
}

TEST_P(PenaltyKick, WithATeamMate390MillimetresBehindTheMarkIsRetakenAfterAGoal) {
  PenaltyGame game("2014", kicker());
  game.put(kicker(), 2, behind_mark(game, 0.39, kFrontDistance_m));
  game.whistle().kick(kPastTheKeeper_mps);
  const Finding again = game.run_until("penalty_positions", 2);
  EXPECT_EQ(again.offender, kicker());
  EXPECT_EQ(again.restart, (Command{CommandKind::kPreparePenalty, kicker()}));
  EXPECT_EQ(game.state.signal.goals[kicker()], 0);
  EXPECT_NEAR((again.ball_to_m - game.at(game.mark_m)).norm(), 0, 1e-12);
}

TEST_P(PenaltyKick, WithATeamMate410MillimetresBehindTheMarkCounts) {
  PenaltyGame game("2014", kicker());
  game.put(kicker(), 2, behind_mark(game, 0.41, kFrontDistance_m));
  game.whistle().kick(kPastTheKeeper_mps);
  EXPECT_NO_THROW(game.run_until("goal", 2));
}

TEST_P(PenaltyKick, WithATeamMateTooNearIsNotRetakenWithoutAGoal) {
  PenaltyGame game("2014", kicker());
  game.put(kicker(), 2, behind_mark(game, 0.2));
  game.whistle().kick(kPastTheGoal_mps);
  EXPECT_NO_THROW(game.run_until("goal_kick", 3));
}

TEST_P(PenaltyKick, WithADefenderTooNearIsRetakenWithoutAGoal) {
  PenaltyGame game("2014", kicker());
  game.put(defender(), 2, behind_mark(game, 0.2));
  game.whistle().kick(kPastTheGoal_mps);
  EXPECT_EQ(game.run_until("penalty_positions", 3).offender, defender());
}

TEST_P(PenaltyKick, WithADefenderTooNearCountsAfterAGoal) {
  PenaltyGame game("2014", kicker());
  game.put(defender(), 2, behind_mark(game, 0.2));
  game.whistle().kick(kPastTheKeeper_mps);
  EXPECT_NO_THROW(game.run_until("goal", 2));
}

TEST_P(PenaltyKick, WithBothSidesTooNearIsRetaken) {
  PenaltyGame game("2014", kicker());
  game.put(kicker(), 2, behind_mark(game, 0.2));
  game.put(defender(), 2, behind_mark(game, 0.2) + Vec2(0, 0.3));
  game.whistle().kick(kPastTheGoal_mps);
  EXPECT_FALSE(game.run_until("penalty_positions", 3).offender.has_value());
}

// "touches its goal line": its back reaches 90 mm, the line is 10 mm wide.
TEST_P(PenaltyKick, WithTheKeeperOffItsLineIsRetakenWithoutAGoal) {
  for (const double in_front_m : {0.09, 0.11}) {
    PenaltyGame game("2014", kicker());
    game.put(defender(), 0, {3.025 - in_front_m, -0.2});
    game.whistle().kick(kPastTheGoal_mps);
    game.run(1);
    EXPECT_EQ(game.count("penalty_positions"), in_front_m > 0.1 ? 1 : 0);
  }
}

// 2026: 1 m behind the ball; "a goal is awarded if the defending team commits any foul"
TEST_P(PenaltyKick, In2026IsAGoalIfADefenderIsWithinOneMetreBehindTheBall) {
  for (const double gap_m : {0.99, 1.01}) {
    PenaltyGame game("2026-b", kicker());
    game.put(defender(), 2, behind_mark(game, gap_m));
    game.whistle().kick({5.5, 2});
    game.run(1.5);
    EXPECT_EQ(game.count("penalty_positions"), gap_m < 1 ? 1 : 0);
    EXPECT_EQ(game.count("goal"), gap_m < 1 ? 1 : 0);
    EXPECT_EQ(game.state.signal.goals[kicker()], gap_m < 1 ? 1 : 0);
    EXPECT_EQ(game.count("penalty_kick_failed"), gap_m < 1 ? 0 : 1);
  }
}

// "A goal is not awarded if the attacking team violates any rule"
TEST_P(PenaltyKick, In2026FailsIfATeamMateIsWithinOneMetreBehindTheBall) {
  for (const double gap_m : {0.99, 1.01}) {
    PenaltyGame game("2026-b", kicker());
    game.put(kicker(), 2, behind_mark(game, gap_m, kFrontDistance_m));
    game.whistle().kick({6, 0.3});
    game.run(1.5);
    EXPECT_EQ(game.count("penalty_kick_failed"), gap_m < 1 ? 1 : 0);
    EXPECT_EQ(game.state.signal.goals[kicker()], gap_m < 1 ? 0 : 1);
  }
}

// If both sides break the rules, the rules do not say who wins: the kick's outcome decides.
TEST_P(PenaltyKick, In2026IsDecidedByItsOutcomeIfBothSidesAreTooNear) {
  for (const bool scores : {false, true}) {
    PenaltyGame game("2026-b", kicker());
    game.put(kicker(), 2, behind_mark(game, 0.8));
    game.put(defender(), 2, behind_mark(game, 0.8) + Vec2(0, 0.3));
    game.whistle().kick(scores ? Vec2(6, 0.3) : Vec2(5.5, 2));
    game.run(2);
    EXPECT_EQ(game.count("penalty_positions"), 1);
    EXPECT_EQ(game.count("goal"), scores ? 1 : 0);
    EXPECT_EQ(game.count("penalty_kick_failed"), scores ? 0 : 1);
  }
}

// "The ball has to only move towards the opponent goal"
TEST_P(PenaltyKick, In2026FailsIfTheBallMovesBack) {
  PenaltyGame game("2026-b", kicker());
  game.whistle().kick({-1, 0});
  const Finding failed = game.run_until("penalty_kick_failed", 1);
  EXPECT_EQ(failed.unit, "m");
  EXPECT_NEAR(failed.value, 0.05, 0.03);
}

TEST_P(PenaltyKick, In2026GoesOnIfTheBallMovesSideways) {
  PenaltyGame game("2026-b", kicker());
  game.whistle().kick({0.01, 1});
  game.run(2);
  EXPECT_EQ(game.count("penalty_kick_failed"), 0);
}

}  // namespace
}  // namespace autoref::referee
