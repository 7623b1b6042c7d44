#include "strategies/tactics/predicted_state.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

TEST(PredictedState, AssignsPossessionToTheTeamThatReachesTheBallFirst) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {0.5, 0}).opponent(0, {2, 0}).ball({0, 0});
  EXPECT_TRUE(stage.look().is_ours());
  stage.world.view.opponents[0].position_m = {-0.3, 0};
  stage.world.view.own[0].position_m = {2, 0};
  EXPECT_FALSE(stage.look().is_ours());
}

// Without hysteresis, a team could decide differently in every frame of an even race for the ball.
// Whether the ball is the team's once both robots are 0.8 m from it, having been that far away.
bool is_ours_in_even_race(double own_x_m, double opponent_x_m) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {own_x_m, 0}).opponent(0, {opponent_x_m, 0}).ball({0, 0});
  stage.look();
  stage.world.view.own[0].position_m = {0.8, 0};
  stage.world.view.opponents[0].position_m = {-0.8, 0};
  return stage.look().is_ours();
}

TEST(PredictedState, KeepsPossessionIfBothTeamsAreAboutAsNear) {
  EXPECT_TRUE(is_ours_in_even_race(0.5, -2.0));
  EXPECT_FALSE(is_ours_in_even_race(2.0, -0.5));
}

TEST(PredictedState, ExtrapolatesRobotsToWhenCommandsTakeEffect) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {0, 0}).view.own[0].velocity_mps = {2, 0};
  stage.world.view.latency_s = 0.05;
  EXPECT_NEAR(stage.look(1).robot(0).position_m.x(), 0.1, 0.01);
}

TEST(PredictedState, PlansForWhereTheRefereeIsAboutToPlaceTheBall) {
  StagedPrediction stage(Play::kStop);
  stage.world.ball({2, 1}).view.placement_m = Vec2(-1, 0.5);
  EXPECT_EQ(stage.look().position_m(), Vec2(-1, 0.5));
}

TEST(PredictedState, FindsTheOpponentThatReachesTheBallFirst) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {-2, 0}).opponent(0, {2, 0}).opponent(3, {0.4, 0.2}).ball({0, 0});
  EXPECT_EQ(stage.look().their_fastest(), 1);
  EXPECT_LT(stage.predicted.theirs().time_s, 1);
}

TEST(PredictedState, KeepsAwayFromTheBallOnlyAtTheOpponentsRestarts) {
  StagedPrediction theirs(Play::kDirectFree, false);
  EXPECT_GE(theirs.look().room_at_ball_m(), RuleBook{}.opponents_to_ball_m);
  EXPECT_GE(theirs.predicted.limits().keep_from_ball_m, 0.5 + kRobotRadius_m);
  StagedPrediction ours(Play::kDirectFree, true);
  EXPECT_EQ(ours.look().room_at_ball_m(), 0);
  StagedPrediction running(Play::kRunning);
  EXPECT_EQ(running.look().room_at_ball_m(), 0);
}

TEST(PredictedState, StaysInItsOwnHalfOnlyForAKickoff) {
  StagedPrediction kickoff(Play::kPrepareKickoff);
  EXPECT_TRUE(kickoff.look().limits().own_half_only);
  StagedPrediction before(Play::kStop);
  before.world.view.next = CommandKind::kPrepareKickoff;
  EXPECT_TRUE(before.look().limits().own_half_only);
  StagedPrediction free_kick(Play::kDirectFree);
  EXPECT_FALSE(free_kick.look().limits().own_half_only);
}

TEST(PredictedState, KicksBelowTheLimitOnlyIfARuleRequiresIt) {
  StagedPrediction paper(Play::kRunning);
  EXPECT_EQ(paper.look().allowed_kick_mps(8), 8);
  StagedPrediction strict(Play::kRunning, false, team_context_of("2026-b"));
  EXPECT_LT(strict.look().allowed_kick_mps(8), 6.5);
  EXPECT_GT(strict.predicted.allowed_kick_mps(8), 4);
  EXPECT_EQ(strict.predicted.allowed_kick_mps(3), 3);
}

TEST(PredictedState, MustNotTouchTheBallInEitherAreaIfTheRulesForbidIt) {
  StagedPrediction strict(Play::kRunning, false, team_context_of("2026-b"));
  strict.world.own(0, {0, 0}).own(1, {1, 0});
  strict.look();
  EXPECT_FALSE(strict.predicted.may_touch_at({4, 0}));
  EXPECT_FALSE(strict.predicted.may_touch_at({-4, 0}));
  EXPECT_TRUE(strict.predicted.may_touch_at({3, 0}));
  StagedPrediction paper(Play::kRunning);
  paper.world.own(0, {0, 0}).own(1, {1, 0});
  EXPECT_TRUE(paper.look().may_touch_at({2.8, 0}));
}

TEST(EaseOff, SlowsDownARobotThatWouldRunIntoAnOpponent) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {0, 0}).opponent(0, {2 * kRobotRadius_m + 0.05, 0});
  RobotCommand command;
  command.velocity_mps = {3, 0.5};
  ease_off(stage.look(), 0, command);
  EXPECT_LT(command.velocity_mps.x(), RuleBook{}.crash_mps);
  EXPECT_NEAR(command.velocity_mps.y(), 0.5, 1e-9);
}

Vec2 eased_off_mps(StagedPrediction& stage, const Vec2& velocity_mps) {
  RobotCommand command;
  command.velocity_mps = velocity_mps;
  ease_off(stage.look(), 0, command);
  return command.velocity_mps;
}

TEST(EaseOff, DoesNotChangeCommandsThatLeadPastOpponentsOrAway) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {0, 0}).opponent(0, {0.3, 0}).opponent(1, {2, 0});
  EXPECT_EQ(eased_off_mps(stage, {-3, 0}), Vec2(-3, 0));
  EXPECT_EQ(eased_off_mps(stage, {0, 3}), Vec2(0, 3));
  EXPECT_EQ(eased_off_mps(stage, {0.3, 0}), Vec2(0.3, 0));
}

TEST(GoTo, LeavesTheBallsCircleDirectly) {
  StagedPrediction stage(Play::kStop);
  stage.world.own(0, {-2.8, 0}).own(1, {0.2, 0.1}).ball({0, 0});
  TrackedRobot& robot = stage.world.view.own[1];
  double last_m = 0;
  for (int frame = 0; frame < 120; ++frame) {
    stage.look(1);
    obey(robot, go_to(stage.predicted, 1, {{-1.5, 0}, {1, 0}}));
    const double gap_m = robot.position_m.norm();
    if (last_m < 0.5) {
      ASSERT_GE(gap_m, last_m - 1_mm) << frame;
    }
    last_m = gap_m;
  }
  EXPECT_GE(last_m, 0.5 + kRobotRadius_m);
}

}  // namespace
}  // namespace autoref::strategies
