#include "live/controller/followed_signal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "league/referee_message.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::live {
namespace {

class FollowedSignalTest : public testing::Test {
 protected:
  FollowedSignalTest() {
    game_ = short_game_by("2026-b", 30, 4);
    game_.match.placement = referee::PlacedBy::kTeams;
    given_.command = {CommandKind::kStop};
    given_.command_counter = 1;
    given_.next_command = Command{CommandKind::kDirectFree, Side::kEast};
    given_.placement = Placement{{1, 2}};
  }

  league::RefereePacket packet() const {
    league::RefereePacket packet;
    league::fill_referee(given_, {}, 0, packet);
    return packet;
  }

  // The signal in a game after this one has been given.
  RefereeSignal taken(double now_s = 0) {
    if (!followed_) followed_.emplace(game_);
    EXPECT_TRUE(followed_->take(packet(), now_s));
    return followed_->signal();
  }

  game::GameConfiguration game_;
  RefereeSignal given_;
  std::optional<FollowedSignal> followed_;
};

TEST_F(FollowedSignalTest, FreeKicksAndStopsWithoutARestartAreLeftToTheTeams) {
  EXPECT_FALSE(taken().placement->by_hand);
  given_.next_command.reset();
  EXPECT_FALSE(taken().placement->by_hand);
  given_.command = {CommandKind::kBallPlacement, Side::kEast};
  EXPECT_FALSE(taken().placement->by_hand);
}

TEST_F(FollowedSignalTest, KickoffsArePlacedByHand) {
  given_.next_command = Command{CommandKind::kPrepareKickoff, Side::kEast};
  EXPECT_TRUE(taken().placement->by_hand);
}

TEST_F(FollowedSignalTest, EverythingIsPlacedByHandIfTheSimulatorPlacesTheBall) {
  game_.match.placement = referee::PlacedBy::kSimulator;
  EXPECT_TRUE(taken().placement->by_hand);
}

TEST_F(FollowedSignalTest, PositionDuringPlayDoesNotCount) {
  given_.command = {CommandKind::kForceStart};
  EXPECT_FALSE(taken().placement);
}

TEST_F(FollowedSignalTest, AnotherCommandIsNewEvenWithTheSameNumber) {
  EXPECT_EQ(taken(5).command_time_s, 5);
  EXPECT_EQ(taken(6).command_time_s, 5);
  given_.command = {CommandKind::kHalt};
  EXPECT_EQ(taken(7).command_time_s, 7);
}

TEST_F(FollowedSignalTest, ImpossiblePositionsDoNotReachTheGame) {
  given_.placement = Placement{{std::numeric_limits<double>::quiet_NaN(), 0}};
  EXPECT_FALSE(taken().placement);
  given_.placement = Placement{{1e30, -1e30}};
  const Vec2 target_m = taken().placement->target_m;
  EXPECT_LT(target_m.x(), game_.field.wall_x_m());
  EXPECT_GT(target_m.y(), -game_.field.wall_y_m());
}

TEST_F(FollowedSignalTest, UnknownCommandsAreIgnored) {
  taken();
  league::RefereePacket unknown = packet();
  unknown.set_command(99);
  EXPECT_FALSE(followed_->take(unknown, 1));
  EXPECT_EQ(followed_->signal().command, given_.command);
}

}  // namespace
}  // namespace autoref::live
