#include "live/simulator/team_ports.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <string>

#include "benchmarks/beside_live_game.hpp"
#include "league/messages/simulation.pb.h"

namespace autoref::live {
namespace {

constexpr std::chrono::seconds kRequestPatience{60};
constexpr double kRequestRate_hz = 60;

game::GameConfiguration game_on_network() {
  game::GameConfiguration game;
  game.a.on_network = game.b.on_network = true;
  return game;
}

// The ports of a game in which teams must not control the simulator.
class PortsTest : public testing::Test {
 protected:
  explicit PortsTest(Pace pace = Pace::kClock)
      : client_(thread_, {}, [this](std::string_view bytes, const Address&) {
          answer_.set_value(std::string(bytes));
          return std::nullopt;
        }) {
    options_.speed.pace = pace;
    options_.ports.yellow = benchmarks::free_ports(thread_, 1).front();
    options_.ports.blue = options_.ports.control = options_.ports.grsim = 0;
    ports_.emplace(
        thread_, options_, game_on_network(),
        PortTargets{&slots_, &control_, &robots_, pace == Pace::kLockStep ? &lock_step_ : nullptr});
  }

  void send(const simulation::SimulationSyncRequest& request) {
    client_.send(request.SerializeAsString(), {kLoopback, options_.ports.yellow});
  }

  // The code of the first error in the answer; empty if there is none.
  std::string error_in_answer() {
    if (arrived_.wait_for(kRequestPatience) != std::future_status::ready) return "no answer";
    simulation::SimulationSyncResponse response;
    if (!response.ParseFromString(arrived_.get())) return "not a response";
    const auto& errors = response.robot_control_response().errors();
    return errors.empty() ? "" : errors[0].code();
  }

  // Lets the lock-step go on until it has answered the yellow team.
  void complete_frame() {
    const auto deadline = LockStep::Clock::now() + kRequestPatience;
    while (LockStep::Clock::now() < deadline &&
           arrived_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      lock_step_.advance(
          1, {}, slots_, [](const league::SimulatorRequest&) {},
          LockStep::Clock::now() + std::chrono::milliseconds(5));
  }

  NetworkThread thread_;
  LiveOptions options_;
  CommandSlots slots_{6};
  ControlRequests control_;
  RobotUpdates robots_{game_on_network()};
  LockStep lock_step_{{{true, false}}, kRequestRate_hz};
  std::promise<std::string> answer_;
  std::future<std::string> arrived_ = answer_.get_future();
  DatagramReceiver client_;
  std::optional<TeamPorts> ports_;
};

class PortsInLockStep : public PortsTest {
 protected:
  PortsInLockStep() : PortsTest(Pace::kLockStep) {}
};

simulation::SimulationSyncRequest request_for_a_step() {
  simulation::SimulationSyncRequest request;
  request.set_sim_step(1 / 60.0F);
  return request;
}

TEST_F(PortsTest, ARequestForAStepOutsideLockStepIsAnError) {
  send(request_for_a_step());
  EXPECT_EQ(error_in_answer(), "NO_LOCK_STEP");
}

TEST_F(PortsInLockStep, ATeamMustNotControlTheSimulatorIfTheControlPortIsClosed) {
  simulation::SimulationSyncRequest request = request_for_a_step();
  request.mutable_simulator_command()->mutable_control()->mutable_teleport_ball()->set_x(1);
  send(request);
  complete_frame();
  EXPECT_EQ(error_in_answer(), "CONTROL_CLOSED");
}

}  // namespace
}  // namespace autoref::live
