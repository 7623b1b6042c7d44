// The league's units (millimetres as float, times as integer micro- or nanoseconds) and its numbers
// of the teams.
#pragma once

#include <cmath>
#include <cstdint>

#include "soccer/geometry.hpp"

namespace autoref::league {

// Team in the league's messages; 0 is unknown.
inline constexpr int kYellowTeam = 1;
inline constexpr int kBlueTeam = 2;

inline float to_mm(double metres) { return static_cast<float>(metres * 1000.0); }
inline double to_m(float mm) { return static_cast<double>(mm) / 1000.0; }
inline double to_m(std::int32_t mm) { return static_cast<double>(mm) / 1000.0; }

inline std::int64_t to_ns(double seconds) { return std::llround(seconds * 1e9); }
inline std::int64_t to_us(double seconds) { return std::llround(seconds * 1e6); }

}  // namespace autoref::league
