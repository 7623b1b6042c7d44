#include "live/controller/controller_operator.hpp"

#include <gtest/gtest.h>

#include "league/game_event_message.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::live {
namespace {

using Action = league::ContinueAction;

class ControllerOperatorTest : public testing::Test {
 protected:
  // The action at a time, with this much left on the controller's clock; TYPE_UNKNOWN: none.
  Action::Type action_at(double time_s, double left_s = 300) {
    tracks_.time_s = time_s;
    signal_.stage_time_left_s = left_s;
    const ControllerOperator::Inputs inputs = operator_.act(packet_, signal_, tracks_);
    for_team_ = inputs.empty() ? 0 : inputs[0].continue_action().for_team();
    return inputs.empty() ? Action::TYPE_UNKNOWN : inputs[0].continue_action().type();
  }

  void command(CommandKind kind, Stage stage = Stage::kFirstHalf) {
    signal_.command = {kind, Side::kWest};
    signal_.stage = stage;
    ++signal_.command_counter;
  }

  void let_teams_place() {
    game::GameConfiguration game = short_game(30, 4);
    game.match.placement = referee::PlacedBy::kTeams;
    operator_ = ControllerOperator(game);
  }

  void play() {
    command(CommandKind::kForceStart);
    action_at(-1);
  }

  // A STOP before a free kick of yellow at (1, 1), with the ball at rest in this position.
  void stop_with_ball_at(const Vec2& ball_m) {
    command(CommandKind::kStop);
    signal_.next_command = Command{CommandKind::kDirectFree, Side::kWest};
    signal_.placement = Placement{{1, 1}};
    tracks_.ball = TrackedBall{};
    tracks_.ball->position_m = ball_m;
  }

  void add_event(GameEventType type, Side by_team) {
    GameEvent event;
    event.type = type;
    event.by_team = by_team;
    league::add_game_event(event, packet_);
  }

  void add_possible_goal_of_blue(std::uint64_t touched_us) {
    GameEvent goal;
    goal.type = GameEventType::kPossibleGoal;
    goal.by_team = Side::kEast;
    goal.last_touch_by_team_us = touched_us;
    league::add_game_event(goal, packet_);
  }

  ControllerOperator operator_{short_game(30, 4)};
  league::RefereePacket packet_;
  RefereeSignal signal_;
  Tracks tracks_;
  int for_team_ = 0;
};

TEST_F(ControllerOperatorTest, ResumesFromAHaltAfterASecond) {
  command(CommandKind::kHalt);
  EXPECT_EQ(action_at(0), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(0.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(1.1), Action::RESUME_FROM_HALT);
}

TEST_F(ControllerOperatorTest, DoesOneThingASecond) {
  command(CommandKind::kHalt);
  action_at(0);
  EXPECT_EQ(action_at(1.1), Action::RESUME_FROM_HALT);
  EXPECT_EQ(action_at(2.0), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(2.2), Action::RESUME_FROM_HALT);
}

TEST_F(ControllerOperatorTest, AcceptsAGoalBeforeItResumes) {
  command(CommandKind::kHalt);
  add_possible_goal_of_blue(5);
  action_at(0);
  EXPECT_EQ(action_at(1.1), Action::ACCEPT_GOAL);
  EXPECT_EQ(for_team_, 2);
  EXPECT_EQ(action_at(2.2), Action::RESUME_FROM_HALT);
}

TEST_F(ControllerOperatorTest, RejectsAGoalThatAutoRefDoesNotCount) {
  referee::Decision decision;
  decision.finding.event = referee::Event::kChippedGoal;
  decision.finding.offender = Side::kEast;
  operator_.on_decision(decision);
  command(CommandKind::kHalt);
  add_possible_goal_of_blue(5);
  action_at(0);
  EXPECT_EQ(action_at(1.1), Action::REJECT_GOAL);
}

TEST_F(ControllerOperatorTest, StartsAKickoffOnceTheBallIsInPosition) {
  command(CommandKind::kPrepareKickoff);
  signal_.placement = Placement{};
  tracks_.ball = TrackedBall{};
  tracks_.ball->position_m = {0.2, 0};
  EXPECT_EQ(action_at(0), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(4), Action::TYPE_UNKNOWN);
  tracks_.ball->position_m = {0.05, 0};
  EXPECT_EQ(action_at(5), Action::NORMAL_START);
}

TEST_F(ControllerOperatorTest, StartsAKickoffWithoutABallAfterTenSeconds) {
  command(CommandKind::kPrepareKickoff);
  action_at(0);
  EXPECT_EQ(action_at(9.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(10.1), Action::NORMAL_START);
}

TEST_F(ControllerOperatorTest, DecidesAGoalOnlyOnce) {
  command(CommandKind::kHalt);
  add_possible_goal_of_blue(5);
  add_event(GameEventType::kGoal, Side::kEast);
  action_at(0);
  EXPECT_EQ(action_at(1.1), Action::RESUME_FROM_HALT);
}

TEST_F(ControllerOperatorTest, ContinuesTwoSecondsAfterAStop) {
  play();
  stop_with_ball_at({1, 1.05});
  action_at(0);
  EXPECT_EQ(action_at(1.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(2.0), Action::NEXT_COMMAND);
}

TEST_F(ControllerOperatorTest, GivesTheTeamsTenSecondsAfterAHalt) {
  command(CommandKind::kHalt);
  action_at(0);
  EXPECT_EQ(action_at(1.1), Action::RESUME_FROM_HALT);
  stop_with_ball_at({1, 1.05});
  action_at(1.2);
  EXPECT_EQ(action_at(11.1), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(11.2), Action::NEXT_COMMAND);
}

TEST_F(ControllerOperatorTest, WaitsForOpponentsNearTheBallButNotForEver) {
  play();
  stop_with_ball_at({1, 1.05});
  TrackedRobot robot;
  robot.position_m = {1, 1.3};
  tracks_.robots[Side::kEast].push_back(robot);
  action_at(0);
  EXPECT_EQ(action_at(11.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(12.0), Action::NEXT_COMMAND);
}

TEST_F(ControllerOperatorTest, NeverContinuesWithTheBallElsewhere) {
  play();
  stop_with_ball_at({1, 1.5});
  action_at(0);
  EXPECT_EQ(action_at(100), Action::TYPE_UNKNOWN);
  EXPECT_TRUE(operator_.places_ball());
}

TEST_F(ControllerOperatorTest, LetsTheTeamsPlaceTheBallAndThenPlacesIt) {
  let_teams_place();
  const auto next_stop = [&](double time_s) {
    stop_with_ball_at({-1, -1});
    action_at(time_s);
    return action_at(time_s + 1.1);
  };
  EXPECT_EQ(next_stop(0), Action::BALL_PLACEMENT_START);
  EXPECT_EQ(for_team_, 1);
  add_event(GameEventType::kPlacementFailed, Side::kWest);
  EXPECT_EQ(next_stop(10), Action::BALL_PLACEMENT_START);
  EXPECT_EQ(for_team_, 2);
  EXPECT_FALSE(operator_.places_ball());
  add_event(GameEventType::kPlacementFailed, Side::kEast);
  EXPECT_EQ(next_stop(20), Action::TYPE_UNKNOWN);
  EXPECT_TRUE(operator_.places_ball());
  tracks_.ball->position_m = {1, 1};
  EXPECT_EQ(action_at(25), Action::NEXT_COMMAND);
}

TEST_F(ControllerOperatorTest, PlacesTheBallItselfIfATeamTakesTooLong) {
  let_teams_place();
  stop_with_ball_at({-1, -1});
  tracks_.ball->velocity_mps = {1, 0};
  action_at(0);
  EXPECT_EQ(action_at(39), Action::TYPE_UNKNOWN);
  EXPECT_FALSE(operator_.places_ball());
  EXPECT_EQ(action_at(40), Action::TYPE_UNKNOWN);
  EXPECT_TRUE(operator_.places_ball());
}

TEST_F(ControllerOperatorTest, ForcesAStartWithoutANextCommandAfterFortySeconds) {
  command(CommandKind::kStop);
  action_at(0);
  EXPECT_EQ(action_at(39.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(40), Action::FORCE_START);
}

TEST_F(ControllerOperatorTest, WaitsUntilReportedEventsHaveCounted) {
  command(CommandKind::kForceStart);
  action_at(0, 300);
  operator_.await_event(31);
  EXPECT_EQ(action_at(30.5, 269.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(31, 269.4), Action::NEXT_STAGE);
}

TEST_F(ControllerOperatorTest, AHaltIsEndedWhileEventsAreToCount) {
  command(CommandKind::kHalt);
  action_at(0);
  operator_.await_event(2);
  EXPECT_EQ(action_at(1.1), Action::RESUME_FROM_HALT);
}

TEST_F(ControllerOperatorTest, LetsAPenaltyKickBeTakenAfterTheTimeUnder2026) {
  operator_ = ControllerOperator(short_game_by("2026-b", 30, 4));
  command(CommandKind::kForceStart);
  action_at(0, 300);
  command(CommandKind::kStop);
  signal_.next_command = Command{CommandKind::kPreparePenalty, Side::kWest};
  EXPECT_EQ(action_at(30, 269.9), Action::TYPE_UNKNOWN);
  signal_.next_command.reset();
  command(CommandKind::kPreparePenalty);
  EXPECT_EQ(action_at(31, 269.9), Action::TYPE_UNKNOWN);
  command(CommandKind::kNormalStart);
  EXPECT_EQ(action_at(35, 265), Action::TYPE_UNKNOWN);
  command(CommandKind::kStop);
  EXPECT_EQ(action_at(40, 264), Action::NEXT_STAGE);
}

TEST_F(ControllerOperatorTest, EndsTheGameAtTenGoalsUnder2026) {
  operator_ = ControllerOperator(short_game_by("2026-b", 30, 4));
  command(CommandKind::kHalt);
  signal_.goals = {{10, 9}};
  action_at(0);
  EXPECT_EQ(action_at(1.1), Action::RESUME_FROM_HALT);
  signal_.goals = {{11, 9}};
  EXPECT_EQ(action_at(2.2), Action::END_GAME);
}

TEST_F(ControllerOperatorTest, EndsTheBreakAfterItsLength) {
  game::GameConfiguration game = short_game(30, 4);
  game.match.break_s = 5;
  operator_ = ControllerOperator(game);
  command(CommandKind::kHalt, Stage::kHalfTime);
  action_at(0);
  EXPECT_EQ(action_at(4.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(5), Action::NEXT_STAGE);
}

TEST_F(ControllerOperatorTest, EndsATimeoutWhenItsTimeIsOver) {
  command(CommandKind::kTimeout);
  signal_.timeout_left_s[Side::kWest] = 10;
  action_at(0);
  EXPECT_EQ(action_at(5), Action::TYPE_UNKNOWN);
  signal_.timeout_left_s[Side::kWest] = 0;
  EXPECT_EQ(action_at(10), Action::TIMEOUT_STOP);
}

TEST_F(ControllerOperatorTest, AnActionIsDoneOnceTheMessagesShowIt) {
  play();
  stop_with_ball_at({1, 1.05});
  packet_.set_command_counter(7);
  action_at(0);
  EXPECT_EQ(action_at(2.0), Action::NEXT_COMMAND);
  EXPECT_FALSE(operator_.is_done(packet_));
  packet_.set_command_counter(8);
  EXPECT_TRUE(operator_.is_done(packet_));
}

TEST_F(ControllerOperatorTest, EndsTheFirstHalfByTheControllersClock) {
  command(CommandKind::kForceStart);
  EXPECT_EQ(action_at(0, 300), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(50, 270.1), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(51, 269.9), Action::NEXT_STAGE);
}

TEST_F(ControllerOperatorTest, EndsTheGameAfterTheSecondHalf) {
  command(CommandKind::kForceStart, Stage::kSecondHalf);
  action_at(0, 300);
  EXPECT_EQ(action_at(30.1, 269.9), Action::END_GAME);
}

TEST_F(ControllerOperatorTest, DecidesAGoalBeforeItEndsTheHalf) {
  command(CommandKind::kForceStart);
  action_at(0, 300);
  command(CommandKind::kHalt);
  add_possible_goal_of_blue(5);
  EXPECT_EQ(action_at(29, 269.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(30.1, 269.9), Action::ACCEPT_GOAL);
}

TEST_F(ControllerOperatorTest, DoesNothingAfterTheGame) {
  command(CommandKind::kHalt, Stage::kPostGame);
  action_at(0);
  EXPECT_EQ(action_at(100), Action::TYPE_UNKNOWN);
}

TEST_F(ControllerOperatorTest, SetsUpTheMatchWithNamesAndKeepers) {
  PerSide<TeamRequests> requests;
  requests[Side::kWest].keeper = 3;
  requests[Side::kEast].keeper = 5;
  const ControllerOperator::Inputs inputs = operator_.set_up(requests);
  ASSERT_EQ(inputs.size(), 5);
  EXPECT_TRUE(inputs[0].reset_match());
  EXPECT_FALSE(inputs[1].config_delta().auto_continue());
  EXPECT_TRUE(ControllerOperator::leave()[0].config_delta().auto_continue());
  const auto& blue = inputs[4].change().update_team_state_change();
  EXPECT_EQ(blue.for_team(), 2);
  EXPECT_EQ(blue.goalkeeper().value(), 5);
  EXPECT_TRUE(blue.on_positive_half().value());
}

}  // namespace
}  // namespace autoref::live
