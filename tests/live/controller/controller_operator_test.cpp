#include "live/controller/controller_operator.hpp"

#include <gtest/gtest.h>

#include "league/game_event_message.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::live {
namespace {

using Action = league::ContinueAction;

class ControllerOperatorTest : public testing::Test {
 protected:
  // The action at a time; TYPE_UNKNOWN: none.
  Action::Type action_at(double time_s) {
    tracks_.time_s = time_s;
    const ControllerOperator::Inputs inputs = operator_.act(packet_, signal_, tracks_);
    for_team_ = inputs.empty() ? 0 : inputs[0].continue_action().for_team();
    return inputs.empty() ? Action::TYPE_UNKNOWN : inputs[0].continue_action().type();
  }

  void command(CommandKind kind, Stage stage = Stage::kFirstHalf) {
    signal_.command = {kind, Side::kWest};
    signal_.stage = stage;
    ++signal_.command_counter;
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

TEST_F(ControllerOperatorTest, EndsTheFirstHalfAfterItsLength) {
  command(CommandKind::kForceStart);
  action_at(0);
  EXPECT_EQ(action_at(29.9), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(30.1), Action::NEXT_STAGE);
}

TEST_F(ControllerOperatorTest, DoesNotCountHaltsAsTimePlayed) {
  command(CommandKind::kForceStart);
  action_at(0);
  action_at(10);
  command(CommandKind::kHalt);
  action_at(50);
  command(CommandKind::kForceStart);
  EXPECT_EQ(action_at(60), Action::TYPE_UNKNOWN);
  EXPECT_EQ(action_at(71), Action::NEXT_STAGE);
}

TEST_F(ControllerOperatorTest, EndsTheGameAfterTheSecondHalf) {
  command(CommandKind::kForceStart, Stage::kSecondHalf);
  action_at(0);
  EXPECT_EQ(action_at(30.1), Action::END_GAME);
}

TEST_F(ControllerOperatorTest, DecidesAGoalBeforeItEndsTheHalf) {
  command(CommandKind::kForceStart);
  action_at(0);
  action_at(30);
  command(CommandKind::kHalt);
  add_possible_goal_of_blue(5);
  action_at(31.1);
  EXPECT_EQ(action_at(32.2), Action::ACCEPT_GOAL);
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
  const auto& blue = inputs[4].change().update_team_state_change();
  EXPECT_EQ(blue.for_team(), 2);
  EXPECT_EQ(blue.goalkeeper().value(), 5);
  EXPECT_TRUE(blue.on_positive_half().value());
}

}  // namespace
}  // namespace autoref::live
