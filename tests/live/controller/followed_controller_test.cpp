#include "live/controller/followed_controller.hpp"

#include <gtest/gtest.h>

#include <chrono>
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

  // Plays on until the game has followed the signal.
  void play_with_signal(game::Game& game, FollowedController& controller) {
    ++signal_.command_counter;
    ASSERT_TRUE(send_until([&] {
      game.step();
      controller.follow(game);
      return game.signal().command_counter == signal_.command_counter;
    }));
  }

  game::GameConfiguration configuration_;
  LiveOptions options_;
  RefereeSignal signal_;
  double sent_s_ = 1;
  std::optional<DatagramSender> sender_;
};

TEST_F(FollowedControllerTest, AwaitsAMatchThatIsNotOver) {
  FollowedController controller(configuration_, options_);
  EXPECT_FALSE(controller.awaits_game());
  signal_.stage = Stage::kPostGame;
  std::optional<std::string> notice;
  EXPECT_TRUE(send_until([&] {
    EXPECT_FALSE(controller.awaits_game());
    notice = controller.take_notice();
    return notice.has_value();
  }));
  EXPECT_EQ(notice, "the game controller's match is over; waiting for a new one");
  signal_.stage = Stage::kFirstHalfPre;
  EXPECT_TRUE(send_until([&] { return controller.awaits_game(); }));
}

TEST_F(FollowedControllerTest, BallIsPlacedByHandIfNoTeamCanPlaceIt) {
  FollowedController controller(configuration_, options_);
  game::Game game(configuration_, &controller);
  signal_.stage = Stage::kFirstHalf;
  ASSERT_TRUE(send_until([&] { return controller.awaits_game(); }));
  controller.follow(game);
  signal_.command = {CommandKind::kStop};
  signal_.next_command = Command{CommandKind::kDirectFree, Side::kEast};
  signal_.placement = Placement{{2, 1}};
  play_with_signal(game, controller);
  const auto ball_is_placed = [&] {
    return (game.world().state().ball.position_m - signal_.placement->target_m).norm() < 0.1;
  };
  EXPECT_FALSE(game.signal().placement->by_hand);
  EXPECT_FALSE(ball_is_placed());
  signal_.can_place_ball = {{false, false}};
  EXPECT_TRUE(send_until([&] {
    game.step();
    controller.follow(game);
    return ball_is_placed();
  }));
}

TEST_F(FollowedControllerTest, GameIsPlayedInTheProgramsCoordinates) {
  FollowedController controller(configuration_, options_);
  game::Game game(configuration_, &controller);
  signal_.blue_on_positive_half = false;
  signal_.command = {CommandKind::kStop};
  signal_.placement = Placement{{2, 1}};
  ASSERT_TRUE(send_until([&] { return controller.awaits_game(); }));
  controller.follow(game);
  game.step();
  EXPECT_EQ(game.signal().placement->target_m, Vec2(2, 1));
}

}  // namespace
}  // namespace autoref::live
