// Balls in a goal that do not score: rules indirect_goal, free_kick_own_goal, chipped_goal and
// invalid_goal.
#include <gtest/gtest.h>

#include "referee/rules/rule.hpp"
#include "tests/referee/rules/rule_scene.hpp"

namespace autoref::referee {
namespace {

// West 1 takes a throw-in and shoots it at 5 m/s into the goal of `end`.
ScriptedGame throw_in_shot(const Configuration& configuration, Side end) {
  ScriptedGame game = in_play(configuration);
  game.kick_from(Side::kEast, 1, {0.5, 1.8}, {0, 4});
  game.run_until("throw_in");
  game.robot(Side::kEast, 1).position_m = Vec2(1.5, 0);
  game.run_until("start");
  const Vec2 path_m = configuration.field.goal_centre_m(end) - game.frame.ball->position_m;
  game.kick(Side::kWest, 1, 5 * path_m.normalized());
  return game;
}

TEST(IndirectGoal, FromAThrowInIsAGoalKick) {
  ScriptedGame game = throw_in_shot(by_book("2014"), Side::kEast);
  const Decision call = game.run_until("indirect_goal", 1.5);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_NEAR(game.signal.placement->target_m.x(), 3.025 - 0.5, 1e-9);
  EXPECT_EQ(game.signal.goals[Side::kWest], 0);
}

TEST(IndirectGoal, CountsOnceASecondRobotHasTouchedTheBall) {
  ScriptedGame game = throw_in_shot(by_book("2014"), Side::kEast);
  game.run(0.2);
  game.ball_mps = Vec2(0, 0);
  game.kick(Side::kWest, 2, 5 * (Vec2(3.025, 0) - game.frame.ball->position_m).normalized());
  EXPECT_TRUE(is_called(game, "goal", 1.5));
  EXPECT_EQ(game.count("indirect_goal"), 0);
}

TEST(IndirectGoal, CountsIfAllKicksMayScore) {
  ScriptedGame game = throw_in_shot(by_book("2026-b"), Side::kEast);
  EXPECT_TRUE(is_called(game, "goal", 1.5));
}

TEST(IndirectGoal, CountsIfTheRuleIsNotInForce) {
  ScriptedGame game = throw_in_shot(without(by_book("2014"), RuleId::kIndirectGoal), Side::kEast);
  EXPECT_TRUE(is_called(game, "goal", 1.5));
}

// West 1 shoots from (2, 0).
TEST(Goal, HasTheDetailsOfTheShot) {
  ScriptedGame game = in_play(by_book("2026-b"));
  game.kick_from(Side::kWest, 1, {2, 0}, {5, 0});
  const double kicked_s = game.now_s();
  const EventDetails details = game.run_until("goal", 1).finding.details;
  EXPECT_LE((*details.kick_m - Vec2(2, 0)).norm(), 0.1);
  EXPECT_NEAR(*details.scorers_touched_s, kicked_s, 0.05);
  EXPECT_EQ(details.robots, static_cast<int>(game.frame.robots[Side::kWest].size()));
  EXPECT_NEAR(details.ball_top_m.value_or(0), 2 * kBallRadius_m, 1e-9);
  EXPECT_NEAR(details.ball_m->x(), 4.5, 0.15);
}

TEST(FreeKickOwnGoal, IsACornerKick) {
  ScriptedGame game = throw_in_shot(by_book("2014"), Side::kWest);
  const Decision call = game.run_until("free_kick_own_goal", 1.5);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_LT(game.signal.placement->target_m.x(), -2.9);
  EXPECT_EQ(game.signal.goals[Side::kEast], 0);
}

// "\"The team\" refers to the scoring team ..., not the team that kicked the ball" (2026, Scoring
// Goals); no exception is made for free kicks.
TEST(FreeKickOwnGoal, IsAGoalIn2026) {
  ScriptedGame game = throw_in_shot(by_book("2026-b"), Side::kWest);
  game.run_until("goal", 1.5);
  EXPECT_EQ(game.signal.goals[Side::kEast], 1);
}

TEST(FreeKickOwnGoal, CountsOnceASecondRobotHasTouchedTheBall) {
  ScriptedGame game = throw_in_shot(by_book("2014"), Side::kWest);
  game.run(0.2);
  game.ball_mps = Vec2(0, 0);
  game.kick(Side::kWest, 2, 5 * (Vec2(-3.025, 0) - game.frame.ball->position_m).normalized());
  EXPECT_TRUE(is_called(game, "goal", 1.5));
  EXPECT_EQ(game.signal.goals[Side::kEast], 1);
}

// West 1 shoots at 5 m/s from 1.5 m in front of the goal. Shortly afterwards the ball's lowest
// point is at `height_m` for `up_frames` frames, then it rolls.
ScriptedGame chip(const Configuration& configuration, double height_m, int up_frames) {
  ScriptedGame game = in_play(configuration);
  game.kick_from(Side::kWest, 1, {configuration.field.half_length_m() - 1.5, 0}, {5, 0});
  for (int i = 0; i < 30; ++i) {
    game.frame.ball->height_m = i >= 3 && i < 3 + up_frames ? height_m : 0.0;
    game.step();
  }
  return game;
}

// The ball's top is 43 mm above its lowest point.
TEST(ChipGoal, WithItsTopAbove150MillimetresIsAnIndirectFreeKick) {
  ScriptedGame game = chip(by_book("2014"), 0.108, 12);
  const Decision& call = game.decisions.back();
  EXPECT_EQ(call.transition, "chipped_goal");
  EXPECT_NEAR(call.finding.value, 0.151, 1e-9);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
  EXPECT_NEAR(call.finding.position_m->x(), 1.525, 1e-6);
  EXPECT_EQ(game.signal.goals[Side::kWest], 0);
}

TEST(ChipGoal, BelowThatIsAGoal) { EXPECT_EQ(chip(by_book("2014"), 0.106, 12).count("goal"), 1); }

TEST(ChipGoal, IsAGoalAfterTheBallHasRolled) {
  EXPECT_EQ(chip(by_book("2014"), 0.3, 6).count("goal"), 1);
}

TEST(ChipGoal, IsAGoalIfATeamMateTouchedTheBallLow) {
  ScriptedGame game = in_play(by_book("2014"));
  game.kick_from(Side::kWest, 1, {0, 0}, {5, 0});
  for (int i = 0; i < 5; ++i) {
    game.frame.ball->height_m = 0.2;
    game.step();
  }
  game.frame.ball->height_m = 0;
  game.ball_mps = Vec2(0, 0);
  game.kick(Side::kWest, 2, {7, 0});
  EXPECT_TRUE(is_called(game, "goal", 0.8));
}

TEST(ChipGoal, CountsIfTheRuleIsNotInForce) {
  EXPECT_EQ(chip(without(by_book("2014"), RuleId::kChippedGoal), 0.108, 12).count("goal"), 1);
}

TEST(GoalInvalid, AboveTheHeightIsAGoalKickEvenAfterTheBallHasRolled) {
  ScriptedGame game = chip(by_book("2026-b"), 0.108, 3);
  const Decision& call = game.decisions.back();
  EXPECT_EQ(call.transition, "invalid_goal");
  EXPECT_EQ(call.restart(), (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_NEAR(game.signal.placement->target_m.x(), 4.5 - 1, 1e-9);
}

TEST(GoalInvalid, IsNotCalledBelowTheHeight) {
  EXPECT_EQ(chip(by_book("2026-b"), 0.106, 12).count("goal"), 1);
}

// A ball in the east goal.
std::optional<Finding> goal_in(const Frame& frame, const Configuration& configuration,
                               RefereeState state) {
  state.machine_state = State::kRun;
  const std::optional<BallSight> ball = BallSight{Vec2(4.55, 0), Vec2(4.4, 0)};
  const LastTouch touch;
  const Tracks tracks;
  const PerSide<TeamRequests> requests;
  const FrameHistory frames;
  return kInvalidGoalRule.find(state,
                               {configuration, frame, ball, touch, tracks, requests, frames});
}

// A ball in the east goal, 60 s into the game.
std::optional<Finding> goal_after(const Configuration& configuration, const RefereeState& state) {
  Frame frame;
  frame.time_s = 60;
  return goal_in(frame, configuration, state);
}

TEST(GoalInvalid, WithinTwoSecondsOfTheScorersFoul) {
  RefereeState state;
  state.cards[Side::kWest].fouled_s = 58.1;
  EXPECT_TRUE(goal_after(by_book("2026-b"), state));
  state.cards[Side::kWest].fouled_s = 57.9;
  EXPECT_FALSE(goal_after(by_book("2026-b"), state));
}

TEST(GoalInvalid, IsNotCalledForTheOpponentsFoul) {
  RefereeState state;
  state.cards[Side::kEast].fouled_s = 59;
  EXPECT_FALSE(goal_after(by_book("2026-b"), state));
}

TEST(GoalInvalid, WithMoreRobotsThanAllowed) {
  RefereeState state;
  state.signal.robots_allowed = {{1, 1}};
  for (const int robots : {1, 2}) {
    Frame frame;
    frame.time_s = 60;
    for (int i = 0; i < robots; ++i) {
      frame.robots[Side::kWest].push_back({i, {1.0 * i, 0}, Vec2(1, 0)});
    }
    const std::optional<Finding> call = goal_in(frame, by_book("2026-b"), state);
    EXPECT_EQ(call.has_value(), robots == 2);
  }
}

TEST(GoalInvalid, IsNotCalledAtPenaltyKicks) {
  RefereeState state;
  state.cards[Side::kWest].fouled_s = 59;
  state.play.began_with = {CommandKind::kNormalStart, Side::kWest};
  state.play.ball_from_m = Vec2(-1.5, 0);
  EXPECT_FALSE(goal_after(by_book("2026-b"), state));
}

}  // namespace
}  // namespace autoref::referee
