#include "benchmarks/beside_live_game.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "io/errors.hpp"
#include "league/messages/simulation.pb.h"
#include "league/messages/tracker.pb.h"
#include "league/messages/vision.pb.h"
#include "live/network/stream_server.hpp"

namespace autoref::benchmarks {
namespace {

constexpr int kLowestFreePort = 21'000;
constexpr int kHighestFreePort = 29'999;

template <typename Message>
std::optional<Message> message_in(std::string_view bytes) {
  Message message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return std::nullopt;
  return message;
}

// Lets all robots drive in circles.
std::string circling_commands(int robots) {
  simulation::RobotControl control;
  for (int i = 0; i < robots; ++i) {
    simulation::RobotCommand& command = *control.add_robot_commands();
    command.set_id(static_cast<std::uint32_t>(i));
    simulation::MoveLocalVelocity& velocity =
        *command.mutable_move_command()->mutable_local_velocity();
    velocity.set_forward(0.5F);
    velocity.set_left(0);
    velocity.set_angular(1);
  }
  return control.SerializeAsString();
}

[[noreturn]] void compute_until_killed() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setsid();
  for (volatile unsigned int turns = 0;;) turns = turns + 1;
}

}  // namespace

BareLoop::BareLoop(double frames_per_s, std::chrono::duration<double> delay)
    : thread_([this, frames_per_s, delay](const std::stop_token& stop) {
        std::this_thread::sleep_for(delay);
        live::SteadyFrameClock clock;
        live::FramePacer pacer(clock, frames_per_s);
        while (!stop.stop_requested()) pacer.wait();
        punctuality_ = pacer.punctuality();
      }) {}

live::Punctuality BareLoop::stop() {
  thread_.request_stop();
  thread_.join();
  return punctuality_;
}

BusyProcesses::BusyProcesses(int count) {
  processes_.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const pid_t process = fork();
    if (process < 0) throw io::io_error("cannot start a process", errno);
    if (process == 0) compute_until_killed();
    processes_.push_back(process);
  }
}

BusyProcesses::~BusyProcesses() {
  for (const pid_t process : processes_) {
    kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
  }
}

CommandingThread::CommandingThread(const std::vector<int>& ports, int robots, double packets_per_s)
    : thread_([ports, robots, packets_per_s](const std::stop_token& stop) {
        const std::string bytes = circling_commands(robots);
        std::vector<live::DatagramSender> senders;
        senders.reserve(ports.size());
        for (const int port : ports)
          senders.emplace_back(live::kLoopback, live::Address{live::kLoopback, port});
        live::SteadyFrameClock clock;
        live::FramePacer pacer(clock, packets_per_s);
        while (!stop.stop_requested()) {
          for (live::DatagramSender& sender : senders) sender.send(bytes);
          pacer.wait();
        }
      }) {}

FrameCounter::FrameCounter(live::NetworkThread& thread, NumberOf number_of)
    : receiver_(
          thread, {},
          [this, number_of = std::move(number_of)](std::string_view bytes, const live::Address&) {
            if (const auto number = number_of(bytes)) {
              ++received_;
              last_ = std::max<std::int64_t>(last_, *number);
            }
            return std::nullopt;
          }) {}

std::optional<std::int64_t> vision_frame_in(std::string_view bytes) {
  const auto packet = message_in<league::VisionPacket>(bytes);
  if (!packet || !packet->has_detection() || packet->detection().camera_id() != 0)
    return std::nullopt;
  return packet->detection().frame_number();
}

std::optional<std::int64_t> tracker_frame_in(std::string_view bytes) {
  const auto packet = message_in<league::TrackerPacket>(bytes);
  if (!packet) return std::nullopt;
  return packet->tracked_frame().frame_number();
}

std::vector<int> free_ports(live::NetworkThread& thread, std::size_t count) {
  const auto ignore = [](std::string_view, const live::Address&) { return std::nullopt; };
  std::random_device random;
  std::uniform_int_distribution<int> any(kLowestFreePort, kHighestFreePort);
  std::vector<std::unique_ptr<live::DatagramReceiver>> datagrams;
  std::vector<int> ports;
  for (int attempts = 100; ports.size() < count;) {
    const live::DatagramReceiver::Place place{live::kLoopback, "", any(random), ""};
    try {
      auto receiver = std::make_unique<live::DatagramReceiver>(thread, place, ignore);
      const live::StreamServer connections(thread, place, ignore);
      datagrams.push_back(std::move(receiver));
      ports.push_back(place.port);
    } catch (const io::InputError&) {
      if (--attempts == 0) throw;
    }
  }
  return ports;
}

}  // namespace autoref::benchmarks
