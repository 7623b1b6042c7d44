// Network options of a live game.
#pragma once

#include <cstdint>
#include <string>

#include "live/network/network.hpp"

namespace autoref::live {

// What sets the pace of a live game: the clock, the packets from network teams (as fast as the
// teams answer), or the teams' SimulationSyncRequests.
enum class Pace : std::uint8_t { kClock, kPackets, kLockStep };

struct LiveSpeed {
  Pace pace = Pace::kClock;
  double factor = 1;  // speed relative to real time, with Pace::kClock
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

// Port at which the league's game controller takes events from automatic referees.
inline constexpr int kControllerPort = 10007;

struct LiveOptions {
  LiveSpeed speed;
  std::string interface = kLoopback;  // address of the interface
  std::string unicast;                // host to send to instead of the multicast groups
  LivePorts ports;
  double lapse_s = 0.1;  // a robot stops after this time without a new command
  // Where a game controller in command takes events. If the host is empty, it is the sender of the
  // referee packets.
  Address controller{"", kControllerPort};
  double answer_s = 10;  // longest wait for a team at unlimited speed
};

// The name that AutoRef gives itself in its packets.
inline constexpr const char* kIdentifier = "AutoRef";

inline constexpr const char* kVisionGroup = "224.5.23.2";
inline constexpr const char* kRefereeGroup = "224.5.23.1";

}  // namespace autoref::live
