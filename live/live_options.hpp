// Network options of a live game.
#pragma once

#include <cstdint>
#include <string>

#include "live/network/network.hpp"

namespace autoref::live {

// The pace of a live game is set by the clock, by the network teams' packets (as fast as they
// answer), or by their SimulationSyncRequests.
enum class Pace : std::uint8_t { kClock, kPackets, kLockStep };

struct LiveSpeed {
  Pace pace = Pace::kClock;
  double factor = 1;  // of real time, with Pace::kClock
};

// The league's default ports. Port 0 means closed.
struct LivePorts {
  int vision = 10006;
  int referee = 10003;
  int tracker = 10010;
  int control = 10300;
  int blue = 10301;
  int yellow = 10302;
  int grsim = 20011;
  int grsim_status_blue = 30011;
  int grsim_status_yellow = 30012;
};

struct LiveOptions {
  LiveSpeed speed;
  std::string interface = kLoopback;  // address of the interface
  std::string unicast;                // host to send to instead of the multicast groups
  LivePorts ports;
  double lapse_s = 0.1;  // after this time without an update, a robot stops
  double answer_s = 10;  // longest wait for a team at unlimited speed
};

inline constexpr const char* kVisionGroup = "224.5.23.2";
inline constexpr const char* kRefereeGroup = "224.5.23.1";

}  // namespace autoref::live
