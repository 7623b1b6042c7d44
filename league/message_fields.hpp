// The league's units (millimetres as float, times as integer micro- or nanoseconds) and team
// numbers, and parsing of messages that may be malformed.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include "soccer/geometry.hpp"

namespace autoref::league {

// The numbers of the teams in the league's messages; 0 means unknown.
inline constexpr int kYellowTeam = 1;
inline constexpr int kBlueTeam = 2;

inline float to_mm(double metres) { return static_cast<float>(metres * 1000.0); }
inline double to_m(float mm) { return static_cast<double>(mm) / 1000.0; }
inline double to_m(std::int32_t mm) { return static_cast<double>(mm) / 1000.0; }

inline std::int64_t to_ns(double seconds) { return std::llround(seconds * 1e9); }
inline std::int64_t to_us(double seconds) { return std::llround(seconds * 1e6); }

// Returns whether `bytes` are a complete message. The function parses partially, so that protobuf
// does not print its own messages to stderr.
template <typename Message>
bool parse(std::string_view bytes, Message& message) {
  return message.ParsePartialFromArray(bytes.data(), static_cast<int>(bytes.size())) &&
         message.IsInitialized();
}

}  // namespace autoref::league
