// Whole games in lock-step, over datagrams and over connections.
#include <arpa/inet.h>
#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "league/messages/simulation.pb.h"
#include "live/simulator/live_game.hpp"
#include "tests/live/simulator/caller.hpp"
#include "tests/live/simulator/short_network_game.hpp"

namespace autoref::live {
namespace {

constexpr double kGameRate_hz = 60;

// Commands that change from request to request.
std::string request_of(int number) {
  simulation::SimulationSyncRequest request;
  request.set_sim_step(1 / static_cast<float>(kGameRate_hz));
  for (std::uint32_t robot = 0; robot < 6; ++robot) {
    simulation::RobotCommand& command = *request.mutable_robot_control()->add_robot_commands();
    command.set_id(robot);
    auto& velocity = *command.mutable_move_command()->mutable_local_velocity();
    velocity.set_forward(static_cast<float>(number % 7) / 4);
    velocity.set_left(static_cast<float>(robot) / 8);
    velocity.set_angular(1);
  }
  return request.SerializeAsString();
}

// Plays until the game closes the port, or has been over for a while.
void step_by_datagrams(int port, const std::atomic<bool>& is_over) {
  const int fd = socket(AF_INET, SOCK_DGRAM, 0);
  constexpr timeval kWait{0, 50'000};
  setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &kWait, sizeof kWait);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  std::array<char, 65536> response{};
  for (int number = 0; !is_over; ++number) {
    const std::string request = request_of(number);
    if (::send(fd, request.data(), request.size(), 0) < 0) break;
    while (recv(fd, response.data(), response.size(), 0) <= 0) {
      if (is_over) break;
    }
  }
  close(fd);
}

void step_by_connection(int port, const std::atomic<bool>& /*is_over*/) {
  Caller caller(port);
  for (int number = 0; caller.say(request_of(number)); ++number) {
    if (caller.hear() == "closed") break;
  }
}

using Stepper = std::function<void(int port, const std::atomic<bool>& is_over)>;

LiveOptions lock_step_options() {
  LiveOptions options = loopback_options(Pace::kLockStep);
  options.ports.control = 0;
  return options;
}

class LockStepGame {
 public:
  explicit LockStepGame(LiveOptions options = lock_step_options()) : options_(std::move(options)) {
    live_.emplace(short_network_game(), options_, clock_, [] { return false; });
  }

  game::GameRecord play(const Stepper& yellow, const Stepper& blue) {
    std::thread one([&] { yellow(options_.ports.yellow, is_over_); });
    std::thread two([&] { blue(options_.ports.blue, is_over_); });
    game::GamePrograms programs = game::GamePrograms::live(
        short_network_game(), {},
        [&](const game::TeamConfiguration&, const strategies::TeamContext& context) {
          return live_->make_network_team(context);
        });
    game::GameRecord record = live_->play(nullptr, programs).record;
    report_ = live_->report();
    is_over_ = true;
    live_.reset();  // closes the connections
    one.join();
    two.join();
    return record;
  }

  const LiveReport& report() const { return report_; }

 private:
  LiveOptions options_;
  SteadyFrameClock clock_;
  std::optional<LiveGame> live_;
  LiveReport report_;
  std::atomic<bool> is_over_{false};
};

TEST(LockStepGame, IsTheSameOverConnectionsAsOverDatagrams) {
  LockStepGame datagrams;
  LockStepGame connections;
  LockStepGame mixed;
  const game::GameRecord first = datagrams.play(step_by_datagrams, step_by_datagrams);
  EXPECT_EQ(first.status, game::Status::kOk) << first.void_reason;
  EXPECT_GT(first.frames, 5 * kGameRate_hz);
  EXPECT_EQ(connections.play(step_by_connection, step_by_connection).state_hash, first.state_hash);
  EXPECT_EQ(mixed.play(step_by_connection, step_by_datagrams).state_hash, first.state_hash);
}

TEST(LockStepGame, CountsRequestsOfConnectionsAsPackets) {
  LockStepGame game;
  const game::GameRecord record = game.play(step_by_connection, step_by_connection);
  EXPECT_GE(game.report().traffic[Side::kWest].packets, record.frames - 1);
  EXPECT_EQ(game.report().traffic[Side::kWest].wrong, 0);
}

TEST(LockStepGame, ATeamThatCannotBeReachedAnyMoreFails) {
  LiveOptions options = lock_step_options();
  options.answer_s = 2;
  LockStepGame game(options);
  const auto leaves = [](int port, const std::atomic<bool>&) {
    Caller caller(port);
    for (int number = 0; number < 100; ++number) {
      caller.say(request_of(number));
      caller.hear();
    }
  };
  const game::GameRecord record = game.play(step_by_connection, leaves);
  EXPECT_EQ(record.status, game::Status::kVoid);
  EXPECT_NE(record.void_reason.find("sent no commands for 2 s"), std::string::npos)
      << record.void_reason;
}

}  // namespace
}  // namespace autoref::live
