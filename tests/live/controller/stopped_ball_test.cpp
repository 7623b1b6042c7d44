#include "live/controller/stopped_ball.hpp"

#include <gtest/gtest.h>

#include "tests/support/short_game.hpp"

namespace autoref::live {
namespace {

class StoppedBallTest : public testing::Test {
 protected:
  StoppedBallTest() {
    game_ = short_game_by("2026-b", 30, 4);
    game_.match.placement = referee::PlacedBy::kTeams;
    signal_.command = {CommandKind::kStop, Side::kWest};
    signal_.next_command = Command{CommandKind::kDirectFree, Side::kEast};
    signal_.placement = Placement{{1, 1}};
    put_ball({1, 1});
  }

  void put_ball(const Vec2& position_m, const Vec2& velocity_mps = {0, 0}) {
    tracks_.ball = TrackedBall{};
    tracks_.ball->position_m = position_m;
    tracks_.ball->velocity_mps = velocity_mps;
  }

  void add_event(GameEventType type, Side by_team) {
    GameEvent event;
    event.type = type;
    event.by_team = by_team;
    events_.push_back(event);
  }

  StoppedBall ball() const { return {game_, events_, signal_, tracks_}; }

  game::GameConfiguration game_;
  std::vector<GameEvent> events_;
  RefereeSignal signal_;
  Tracks tracks_;
};

TEST_F(StoppedBallTest, IsReadyWhereNoPlacementIsRequired) {
  put_ball({1, 1.9});
  EXPECT_TRUE(ball().is_ready());
  put_ball({1, 1.9}, {1, 0});
  EXPECT_FALSE(ball().is_ready());
  put_ball({1, 2.1});
  EXPECT_FALSE(ball().is_ready());
}

TEST_F(StoppedBallTest, IsReadyOnlyInPositionIfTheSimulatorPlacesIt) {
  game_.match.placement = referee::PlacedBy::kSimulator;
  put_ball({1, 1.05});
  EXPECT_TRUE(ball().is_ready());
  put_ball({1, 1.2});
  EXPECT_FALSE(ball().is_ready());
  EXPECT_EQ(ball().placer(), std::nullopt);
}

TEST_F(StoppedBallTest, IsReadyNearAPositionBesideAnArea) {
  const double beside_m = game_.field.half_length_m() - game_.field.defence_area.depth_m - 0.5;
  signal_.placement->target_m = {beside_m, 0};
  put_ball({beside_m - 0.1, 0});
  EXPECT_TRUE(ball().is_ready());
  put_ball({beside_m - 0.19, 0});
  EXPECT_FALSE(ball().is_ready());
  add_event(GameEventType::kPlacementSucceeded, Side::kWest);
  EXPECT_TRUE(ball().was_placed_by(Side::kWest));
  EXPECT_FALSE(ball().was_placed_by(Side::kEast));
  EXPECT_TRUE(ball().is_ready());
}

TEST_F(StoppedBallTest, IsNotReadyWhereItWasPlacedForAnotherPosition) {
  add_event(GameEventType::kPlacementSucceeded, Side::kEast);
  signal_.placement->target_m = {-2, 1};
  EXPECT_FALSE(ball().is_ready());
}

TEST_F(StoppedBallTest, IsPlacedByTheKickerThenByTheOpponentsThenByNeither) {
  EXPECT_EQ(ball().placer(), Side::kEast);
  add_event(GameEventType::kPlacementFailed, Side::kEast);
  EXPECT_EQ(ball().placer(), Side::kWest);
  add_event(GameEventType::kPlacementFailed, Side::kWest);
  EXPECT_EQ(ball().placer(), std::nullopt);
}

TEST_F(StoppedBallTest, IsNotPlacedByATeamThatMayNot) {
  signal_.can_place_ball[Side::kEast] = false;
  EXPECT_EQ(ball().placer(), Side::kWest);
}

TEST_F(StoppedBallTest, IsOutOfReachBehindAGoalLineOnceItRests) {
  put_ball({game_.field.half_length_m() + 0.1, 0});
  EXPECT_TRUE(ball().is_out_of_reach());
  put_ball({game_.field.half_length_m() + 0.1, 0}, {0, 1});
  EXPECT_FALSE(ball().is_out_of_reach());
}

TEST_F(StoppedBallTest, IsNotPlacedByTeamsForAKickoff) {
  signal_.next_command = Command{CommandKind::kPrepareKickoff, Side::kWest};
  EXPECT_EQ(ball().placer(), std::nullopt);
}

TEST_F(StoppedBallTest, OnlyOpponentsHaveToLeaveTheBallOfAFreeKick) {
  TrackedRobot robot;
  robot.position_m = {1, 1.3};
  tracks_.robots[Side::kEast].push_back(robot);
  EXPECT_TRUE(ball().are_robots_away());
  signal_.next_command = Command{CommandKind::kPrepareKickoff, Side::kEast};
  EXPECT_FALSE(ball().are_robots_away());
  signal_.next_command = Command{CommandKind::kDirectFree, Side::kWest};
  EXPECT_FALSE(ball().are_robots_away());
}

TEST_F(StoppedBallTest, CanBeUnseen) {
  tracks_.ball.reset();
  EXPECT_FALSE(ball().is_ready());
  EXPECT_FALSE(ball().is_out_of_reach());
  EXPECT_TRUE(ball().are_robots_away());
}

}  // namespace
}  // namespace autoref::live
