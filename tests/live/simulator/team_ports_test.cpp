// The simulation protocol over connections.
#include "live/simulator/team_ports.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "benchmarks/beside_live_game.hpp"
#include "league/messages/simulation.pb.h"
#include "live/simulator/lock_step.hpp"
#include "tests/live/simulator/caller.hpp"

namespace autoref::live {
namespace {

std::string command_of_robot(std::uint32_t robot) {
  simulation::RobotControl control;
  simulation::RobotCommand& command = *control.add_robot_commands();
  command.set_id(robot);
  command.set_dribbler_speed(0);
  return control.SerializeAsString();
}

class TeamPortsTest : public testing::Test {
 protected:
  TeamPortsTest() {
    game_.a.on_network = true;
    const std::vector<int> free = benchmarks::free_ports(thread_, 2);
    options_.ports.yellow = free[0];
    options_.ports.control = free[1];
    options_.ports.grsim = 0;
    open(nullptr);
  }

  void open(LockStep* lock_step) {
    ports_.reset();
    ports_.emplace(thread_, options_, game_, PortTargets{&slots_, &control_, &robots_, lock_step});
  }

  NetworkThread thread_;
  game::GameConfiguration game_;
  LiveOptions options_;
  CommandSlots slots_{6};
  ControlRequests control_;
  RobotUpdates robots_{game_};
  std::optional<TeamPorts> ports_;
};

TEST_F(TeamPortsTest, AConnectionCommandsRobots) {
  simulation::RobotControl request;
  for (const std::uint32_t robot : {0U, 99U}) {
    simulation::RobotCommand& command = *request.add_robot_commands();
    command.set_id(robot);
    auto& velocity = *command.mutable_move_command()->mutable_local_velocity();
    velocity.set_forward(0.5F);
    velocity.set_left(0);
    velocity.set_angular(0);
  }
  Caller team(options_.ports.yellow);
  team.say(request.SerializeAsString());
  simulation::RobotControlResponse response;
  ASSERT_TRUE(response.ParseFromString(team.hear()));
  ASSERT_EQ(response.errors_size(), 1);
  EXPECT_EQ(response.errors(0).code(), "ROBOT_ID");
  EXPECT_EQ(slots_.collect_commands(Side::kWest, 0, {})[0].velocity_mps.x(), 0.5);
  const TeamTraffic traffic = ports_->traffic()[Side::kWest];
  EXPECT_EQ(traffic.packets, 1);
  EXPECT_EQ(traffic.wrong, 0);
  EXPECT_EQ(traffic.absent, 1);
}

simulation::RobotControl commands_of_robots(std::initializer_list<std::uint32_t> numbers) {
  simulation::RobotControl request;
  for (const std::uint32_t number : numbers) request.add_robot_commands()->set_id(number);
  return request;
}

TEST_F(TeamPortsTest, CommandsForAbsentRobotsCountNotThePacketsAndTheFirstIsReported) {
  Caller team(options_.ports.yellow);
  for (int i = 0; i < 2; ++i) {
    team.say(commands_of_robots({0, 8, 1, 11}).SerializeAsString());
    team.hear();
  }
  TeamTraffic traffic = ports_->traffic()[Side::kWest];
  EXPECT_EQ(traffic.packets, 2);
  EXPECT_EQ(traffic.wrong, 0);
  EXPECT_EQ(traffic.absent, 4);
  EXPECT_EQ(traffic.last_error, "");
  const std::string sender = "127.0.0.1:" + std::to_string(team.port());
  EXPECT_EQ(traffic.first_absent, "robot 8, from " + sender);
  EXPECT_EQ(ports_->take_notices(),
            std::vector<std::string>{"yellow has no robot 8, but " + sender +
                                     " commands it; such commands are ignored and counted"});
  simulation::RobotControl wrong = commands_of_robots({8, 0});
  wrong.mutable_robot_commands(1)->set_kick_angle(100);
  team.say(wrong.SerializeAsString());
  team.hear();
  traffic = ports_->traffic()[Side::kWest];
  EXPECT_EQ(traffic.wrong, 1);
  EXPECT_EQ(traffic.absent, 5);
  EXPECT_TRUE(traffic.last_error.starts_with("kick_angle of robot 0")) << traffic.last_error;
  EXPECT_TRUE(ports_->take_notices().empty());
}

// Returns the code of the first error in the response; empty if there is none.
std::string error_code(const std::string& bytes) {
  simulation::RobotControlResponse response;
  if (!response.ParseFromString(bytes)) return "not a response";
  return response.errors_size() == 0 ? "" : response.errors(0).code();
}

TEST_F(TeamPortsTest, OnlyCommandsShowThatATeamIsThere) {
  simulation::SimulatorCommand other;
  other.mutable_control()->set_simulation_speed(1);
  Caller stranger(options_.ports.yellow);
  for (const auto& [packet, code] : std::vector<std::pair<std::string, std::string>>{
           {"\x05hello", "PACKET"},
           {std::string("\x00\xff\x00", 3), "PACKET"},
           {"\x7a\x02hi", "PACKET"},  // a message with a field that is not known
           {"", "NO_COMMANDS"},
           {other.SerializeAsString(), "PACKET"},
           {command_of_robot(99), "ROBOT_ID"}}) {
    stranger.say(packet);
    EXPECT_EQ(error_code(stranger.hear()), code);
    EXPECT_EQ(slots_.packets()[Side::kWest], 0);
  }
  EXPECT_EQ(ports_->traffic()[Side::kWest].packets, 6);
  EXPECT_EQ(ports_->traffic()[Side::kWest].wrong, 5);
  EXPECT_EQ(ports_->traffic()[Side::kWest].absent, 1);
  stranger.say(command_of_robot(0));
  EXPECT_EQ(error_code(stranger.hear()), "");
  EXPECT_EQ(slots_.packets()[Side::kWest], 1);
}

TEST_F(TeamPortsTest, AStrangersPacketIsReportedOnceWithItsSender) {
  Caller stranger(options_.ports.yellow);
  for (int i = 0; i < 3; ++i) {
    stranger.say("\x05hello");
    stranger.hear();
  }
  const std::string sender = "127.0.0.1:" + std::to_string(stranger.port());
  EXPECT_EQ(ports_->take_notices(),
            std::vector<std::string>{"a packet for yellow from " + sender +
                                     " does not start the game: a packet of 6 bytes is not a "
                                     "RobotControl; still waiting for commands"});
  EXPECT_EQ(ports_->traffic()[Side::kWest].last_error,
            "a packet of 6 bytes is not a RobotControl (from " + sender + ")");
  EXPECT_TRUE(ports_->take_notices().empty());
}

TEST_F(TeamPortsTest, ATeamThatIsThereMayCommandNoRobot) {
  Caller team(options_.ports.yellow);
  for (const std::string& packet : {command_of_robot(0), std::string(), std::string("\x05hello")}) {
    team.say(packet);
    team.hear();
  }
  EXPECT_EQ(slots_.packets()[Side::kWest], 2);  // garbage is not an answer
}

// grSim's port takes datagrams only, and does not answer.
TEST_F(TeamPortsTest, GarbageAtTheGrsimPortShowsNoTeam) {
  options_.ports.grsim = benchmarks::free_ports(thread_, 1).front();
  open(nullptr);
  DatagramSender sender(kLoopback, {kLoopback, options_.ports.grsim});
  for (const char* packet : {"\x05hello", "\x7a\x02hi"}) sender.send(packet);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (ports_->traffic()[Side::kWest].wrong < 2 && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(ports_->traffic()[Side::kWest].wrong, 2);
  EXPECT_EQ(slots_.packets()[Side::kWest], 0);
  EXPECT_EQ(ports_->take_notices().size(), 1U);
}

bool advance(LockStep& lock_step, CommandSlots& slots, std::int64_t frame) {
  const auto nothing = [](const league::SimulatorRequest&) {};
  return lock_step.advance(frame, {}, slots, nothing,
                           LockStep::Clock::now() + std::chrono::minutes(1));
}

std::string serialized_step_request() {
  simulation::SimulationSyncRequest request;
  request.set_sim_step(1.0F / 60);
  return request.SerializeAsString();
}

TEST_F(TeamPortsTest, GarbageAtTheControlPortDoesNotTakePartInTheLockStep) {
  LockStep lock_step({{true, false}}, 60);
  open(&lock_step);
  Caller stranger(options_.ports.control);
  stranger.say(std::string("\x0d\x00\x00\x80\x3f\xff", 6));  // begins as a request for a step
  simulation::SimulationSyncResponse response;
  ASSERT_TRUE(response.ParseFromString(stranger.hear()));
  ASSERT_EQ(response.robot_control_response().errors_size(), 1);
  EXPECT_EQ(response.robot_control_response().errors(0).code(), "PACKET");
  EXPECT_EQ(ports_->wrong_control(), 1);
  Caller team(options_.ports.yellow);
  team.say(serialized_step_request());
  EXPECT_TRUE(advance(lock_step, slots_, 0));
  ports_.reset();
}

// The codes of the errors in the response.
std::vector<std::string> codes_heard(Caller& caller) {
  simulation::SimulationSyncResponse response;
  EXPECT_TRUE(response.ParseFromString(caller.hear()));
  std::vector<std::string> codes;
  for (const auto& error : response.robot_control_response().errors())
    codes.push_back(error.code());
  return codes;
}

// A step of 0 s, and one that is not a number.
TEST_F(TeamPortsTest, ARequestWithoutAStepDoesNotStopTheLockStep) {
  LockStep lock_step({{true, false}}, 60);
  open(&lock_step);
  Caller program(options_.ports.control);
  program.say(std::string("\x0d\x00\x00\x00\x00", 5));
  program.say(std::string("\x0d\x00\x00\xc0\x7f", 5));
  simulation::SimulatorCommand last;  // answered at once, when the others have arrived
  last.mutable_control()->set_simulation_speed(1);
  program.say(last.SerializeAsString());
  program.hear();
  Caller team(options_.ports.yellow);
  team.say(serialized_step_request());
  EXPECT_TRUE(advance(lock_step, slots_, 0));
  EXPECT_TRUE(codes_heard(program).empty());
  EXPECT_EQ(codes_heard(program), std::vector<std::string>{"STEP"});
  ports_.reset();
}

TEST_F(TeamPortsTest, AStrangerDoesNotTakeATeamsDetections) {
  LockStep lock_step({{true, false}}, 60);
  open(&lock_step);
  lock_step.add_detection("seen");
  Caller stranger(options_.ports.yellow);
  stranger.say(std::string("\x0d\x00\x00\x00\x00", 5));
  EXPECT_EQ(codes_heard(stranger), std::vector<std::string>{"NO_COMMANDS"});
  Caller team(options_.ports.yellow);
  for (int i = 0; i < 2; ++i) team.say(serialized_step_request());
  for (const int frame : {0, 1}) EXPECT_TRUE(advance(lock_step, slots_, frame));
  simulation::SimulationSyncResponse response;
  ASSERT_TRUE(response.ParseFromString(team.hear()));
  EXPECT_EQ(response.detection_size(), 1);
  ports_.reset();
}

TEST_F(TeamPortsTest, AConnectionControlsTheSimulator) {
  simulation::SimulatorCommand request;
  request.mutable_control()->set_simulation_speed(0.5F);
  Caller program(options_.ports.control);
  program.say(request.SerializeAsString());
  simulation::SimulatorResponse response;
  ASSERT_TRUE(response.ParseFromString(program.hear()));
  EXPECT_EQ(response.errors_size(), 0);
  const std::vector<league::SimulatorRequest> requests = control_.take_all();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].speed, 0.5);
}

// A hundred steps at once: as many as may wait are played, the others refused, and none is lost.
TEST_F(TeamPortsTest, EveryRequestOfAConnectionIsAnswered) {
  LockStep lock_step({{true, false}}, 60);
  open(&lock_step);
  simulation::SimulationSyncRequest request;
  request.set_sim_step(1.0F / 60);
  Caller team(options_.ports.yellow);
  constexpr int kRequests = 100;
  for (int i = 0; i < kRequests; ++i) team.say(request.SerializeAsString());
  int refused = 0;
  int played = 0;
  const auto nothing = [](const league::SimulatorRequest&) {};
  for (std::int64_t frame = 0; played + refused < kRequests; ++frame) {
    simulation::SimulationSyncResponse response;
    if (refused == kRequests - 64)
      lock_step.advance(frame, {}, slots_, nothing, LockStep::Clock::now());
    ASSERT_TRUE(response.ParseFromString(team.hear()));
    const auto& errors = response.robot_control_response().errors();
    ASSERT_LE(errors.size(), 1);
    refused += errors.size();
    played += 1 - errors.size();
    for (const simulation::SimulatorError& error : errors) EXPECT_EQ(error.code(), "BUSY");
  }
  EXPECT_EQ(played, 64);
  ports_.reset();
}

TEST_F(TeamPortsTest, AMessageThatIsTooLongIsCounted) {
  Caller team(options_.ports.yellow);
  team.send("\xff\xff\x7f");
  EXPECT_EQ(team.hear(), "closed");
  EXPECT_EQ(ports_->troubles().invalid, 1);
}

}  // namespace
}  // namespace autoref::live
