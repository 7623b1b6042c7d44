// Threads and processes that run alongside a live game while its punctuality is measured.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include "live/frame_pacer.hpp"
#include "live/network/network.hpp"
#include "soccer/side.hpp"

namespace autoref::benchmarks {

// A thread that does nothing but sleep until each frame is due.
class BareLoop {
 public:
  // The first frame is due after `delay`, so that the loop and the live game do not wake each
  // other.
  BareLoop(double frames_per_s, std::chrono::duration<double> delay);

  // Ends the loop and returns its punctuality.
  live::Punctuality stop();

 private:
  live::Punctuality punctuality_;
  std::jthread thread_;
};

// Processes that never sleep, like other programs on the computer. Since the system first
// distributes processor time between sessions, these processes have a session of their own.
class BusyProcesses {
 public:
  // Throws InputOutputError. Call it before any thread is started.
  explicit BusyProcesses(int count);
  ~BusyProcesses();
  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses& operator=(const BusyProcesses&) = delete;

 private:
  std::vector<pid_t> processes_;
};

// A thread that sends commands to teams in the simulation protocol, one packet per team and period.
class CommandingThread {
 public:
  CommandingThread(const std::vector<int>& ports, int robots, double packets_per_s);

 private:
  std::jthread thread_;
};

// Counts the numbered frames that arrive at a port of this computer.
class FrameCounter {
 public:
  // Returns the frame's number, or nullopt if a packet does not count.
  using NumberOf = std::function<std::optional<std::int64_t>(std::string_view bytes)>;

  FrameCounter(live::NetworkThread& thread, NumberOf number_of);

  int port() const { return receiver_.port(); }
  std::int64_t received() const { return received_; }
  // The number of frames that are missing between frame 0 and the last one received.
  std::int64_t lost() const { return last_ + 1 - received_; }

 private:
  std::atomic<std::int64_t> received_{0};
  std::atomic<std::int64_t> last_{-1};
  live::DatagramReceiver receiver_;
};

// The number of the frame in a packet from vision's first camera, or from a tracker.
std::optional<std::int64_t> vision_frame_in(std::string_view bytes);
std::optional<std::int64_t> tracker_frame_in(std::string_view bytes);

// Different ports of this computer that are currently unused, both for datagrams and for
// connections. They are below the range from which Linux assigns ports to sockets, so that no other
// socket takes one of them before it is used. Throws InputError if none is found.
std::vector<int> free_ports(live::NetworkThread& thread, std::size_t count);

}  // namespace autoref::benchmarks
