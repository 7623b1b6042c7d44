#include "live/controller/followed_controller.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include "benchmarks/beside_live_game.hpp"
#include "league/referee_message.hpp"
#include "live/network/network.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::live {
namespace {

constexpr std::chrono::seconds kLongest{20};

class FollowedControllerTest : public testing::Test {
 protected:
  FollowedControllerTest() {
    NetworkThread thread;
    const std::vector<int> ports = benchmarks::free_ports(thread, 2);
    options_.ports.referee = ports[0];
    options_.controller = {kLoopback, ports[1]};
    configuration_ = short_game_by("2026-b", 30, 4);
    configuration_.match.control = referee::Control::kGameController;
    configuration_.match.placement = referee::PlacedBy::kTeams;
    signal_.command_counter = 1;
    sender_.emplace(kLoopback, Address{*broadcast_address(kLoopback), options_.ports.referee});
  }

  void send() {
    league::RefereePacket packet;
    league::fill_referee(published(signal_), {}, sent_s_, packet);
    packet.set_packet_timestamp(static_cast<std::uint64_t>((sent_s_ += 0.025) * 1e6));
    sender_->send(packet.SerializeAsString());
  }

  // Sends the signal until the condition holds; returns whether it does in the end.
  template <typename Condition>
  bool send_until(const Condition& condition) {
    const auto deadline = std::chrono::steady_clock::now() + kLongest;
    while (!condition()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      send();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }

  // Begins a game that is stopped.
  void begin() {
    controller_.emplace(configuration_, options_);
    game_.emplace(configuration_, &*controller_);
    signal_.stage = Stage::kFirstHalf;
    signal_.command = {CommandKind::kStop};
    ASSERT_TRUE(send_until([&] { return controller_->has_match(); }));
    controller_->follow(*game_);
  }

  // Plays on while the signal is sent until the condition holds; returns whether it does.
  template <typename Condition>
  bool play_until(const Condition& condition) {
    return send_until([&] {
      game_->step();
      controller_->follow(*game_);
      return condition();
    });
  }

  void follow_signal() {
    ++signal_.command_counter;
    ASSERT_TRUE(
        play_until([&] { return game_->signal().command_counter == signal_.command_counter; }));
  }

  void stop_before_free_kick() {
    signal_.command = {CommandKind::kStop};
    signal_.next_command = Command{CommandKind::kDirectFree, Side::kEast};
    signal_.placement = Placement{{2, 1}};
    follow_signal();
  }

  bool is_ball_placed() const {
    return (game_->world().state().ball.position_m - signal_.placement->target_m).norm() < 0.1;
  }

  game::GameConfiguration configuration_;
  LiveOptions options_;
  RefereeSignal signal_;
  double sent_s_ = 1;
  std::optional<DatagramSender> sender_;
  std::optional<FollowedController> controller_;
  std::optional<game::Game> game_;
};

TEST_F(FollowedControllerTest, HasAMatchFromTheFirstCommandToItsEnd) {
  FollowedController controller(configuration_, options_);
  EXPECT_FALSE(controller.has_match());
  const auto says = [&](const std::string& wanted) {
    return send_until([&] {
      EXPECT_FALSE(controller.has_match());
      return controller.take_notice() == wanted;
    });
  };
  signal_.stage = Stage::kPostGame;
  EXPECT_TRUE(says("the game controller's match is over; waiting for a new one"));
  signal_.stage = Stage::kFirstHalfPre;
  EXPECT_TRUE(says("waiting for the game controller's first command after HALT"));
  signal_.command = {CommandKind::kStop};
  EXPECT_TRUE(send_until([&] { return controller.has_match(); }));
}

TEST_F(FollowedControllerTest, BallIsPlacedByHandIfNoTeamMayPlaceIt) {
  begin();
  stop_before_free_kick();
  EXPECT_FALSE(game_->signal().placement->by_hand);
  EXPECT_FALSE(is_ball_placed());
  signal_.can_place_ball = {{false, false}};
  EXPECT_TRUE(play_until([&] { return is_ball_placed(); }));
}

TEST_F(FollowedControllerTest, BallIsPlacedByHandDuringAPlacementIfItIsOutOfReach) {
  begin();
  stop_before_free_kick();
  sim::BallState behind_goal_line = game_->world().state().ball;
  behind_goal_line.position_m = {configuration_.field.half_length_m() + 0.15, 0.3};
  behind_goal_line.velocity_mps = {0, 0};
  game_->put_ball(behind_goal_line);
  signal_.command = {CommandKind::kBallPlacement, Side::kEast};
  follow_signal();
  EXPECT_TRUE(play_until([&] { return is_ball_placed(); }));
}

TEST_F(FollowedControllerTest, AnotherRestartIsLeftToTheTeamsAgain) {
  begin();
  stop_before_free_kick();
  signal_.next_command = Command{CommandKind::kPrepareKickoff, Side::kEast};
  EXPECT_TRUE(play_until([&] { return game_->signal().placement->by_hand; }));
  signal_.next_command = Command{CommandKind::kDirectFree, Side::kEast};
  signal_.placement = Placement{{-2, 1}};
  EXPECT_TRUE(play_until([&] { return !game_->signal().placement->by_hand; }));
}

TEST_F(FollowedControllerTest, GameIsPlayedInTheProgramsCoordinates) {
  signal_.blue_on_positive_half = false;
  signal_.placement = Placement{{2, 1}};
  begin();
  game_->step();
  EXPECT_EQ(game_->signal().placement->target_m, Vec2(2, 1));
}

}  // namespace
}  // namespace autoref::live
