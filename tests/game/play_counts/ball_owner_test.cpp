// Who has the ball, or will take the next restart.
#include <gtest/gtest.h>

#include "tests/game/play_counts/chain_play.hpp"

namespace autoref::game {
namespace {

using referee::Event;

TEST(BallOwner, IsTheTeamWithTheBall) {
  ChainPlay play;
  EXPECT_FALSE(play.statistics.ball_owner());
  play.signal_play();
  play.gain(kEast1, {0, 0});
  ASSERT_TRUE(play.statistics.ball_owner());
  EXPECT_EQ(play.statistics.ball_owner()->team, Side::kEast);
  EXPECT_FALSE(play.statistics.ball_owner()->is_restart);
  EXPECT_FALSE(play.statistics.ball_owner()->shot_chance);
}

// Whoever takes the restart owns the ball from the call on, also if another call changes it before
// it is taken.
TEST(BallOwner, IsTheTeamThatTakesTheNextRestart) {
  ChainPlay play;
  play.gain(kWest1, {0, 0});
  referee::Decision penalty = ChainPlay::call(Event::kBotPushedBot, Side::kWest);
  penalty.finding.restart = {CommandKind::kPreparePenalty, Side::kEast};
  play.stop_by(penalty);
  EXPECT_EQ(play.statistics.ball_owner()->team, Side::kEast);
  EXPECT_TRUE(play.statistics.ball_owner()->is_penalty);
  play.decide(
      ChainPlay::decision_of(Event::kReady, Command{CommandKind::kPreparePenalty, Side::kEast}));
  play.frame();
  EXPECT_TRUE(play.statistics.ball_owner()->is_penalty);
  referee::Decision free_kick = ChainPlay::decision_of(Event::kAttackerStaysNearArea);
  free_kick.finding.restart = {CommandKind::kDirectFree, Side::kWest};
  play.decide(free_kick);
  play.frame();
  EXPECT_EQ(play.statistics.ball_owner()->team, Side::kWest);
  EXPECT_TRUE(play.statistics.ball_owner()->is_restart);
  EXPECT_FALSE(play.statistics.ball_owner()->is_penalty);
}

TEST(BallOwner, IsNobodyBeforeAForceStart) {
  ChainPlay play;
  play.gain(kWest1, {0, 0});
  referee::Decision stuck = ChainPlay::call(Event::kStuckBall);
  stuck.finding.restart = {CommandKind::kForceStart};
  play.stop_by(stuck);
  EXPECT_FALSE(play.statistics.ball_owner());
}

TEST(BallOwner, HasTheChanceOfItsShotOnTheWay) {
  ChainPlay play;
  play.kick(kEast1, {-1, 0}, {-5, 0});
  play.frame();
  ASSERT_TRUE(play.statistics.ball_owner());
  ASSERT_TRUE(play.statistics.ball_owner()->shot_chance);
  EXPECT_GT(*play.statistics.ball_owner()->shot_chance, 0.5);
}

}  // namespace
}  // namespace autoref::game
