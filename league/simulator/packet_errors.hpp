// Bounded lists of what is wrong with a packet.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "league/messages/simulation.pb.h"
#include "league/simulator/command_update.hpp"

namespace autoref::league {

inline constexpr std::size_t kMostErrors = 16;
inline constexpr std::size_t kMostUpdates = 64;  // of a packet

// The code for a packet that is not a message of its port.
inline constexpr const char* kNotAMessage = "PACKET";

// Whether it was one.
inline bool is_readable(const CommandPacket& packet) {
  for (const PacketError& error : packet.errors)
    if (error.code == kNotAMessage) return false;
  return true;
}

// Further errors than the first kMostErrors are dropped.
inline void add_error(std::vector<PacketError>& errors, std::string code, std::string message) {
  if (errors.size() < kMostErrors) errors.push_back({std::move(code), std::move(message)});
}

inline void fill_error(const PacketError& error, simulation::SimulatorError& message) {
  message.set_code(error.code);
  message.set_message(error.message);
}

}  // namespace autoref::league
