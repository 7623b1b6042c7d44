// Conversion to the league's units: millimetres as float, times as integer micro- or nanoseconds.
#pragma once

#include <cmath>
#include <cstdint>

#include "soccer/geometry.hpp"

namespace autoref::league {

inline float to_mm(double metres) { return static_cast<float>(metres * 1000.0); }
inline double to_m(float mm) { return static_cast<double>(mm) / 1000.0; }
inline double to_m(std::int32_t mm) { return static_cast<double>(mm) / 1000.0; }

inline std::int64_t to_ns(double seconds) { return std::llround(seconds * 1e9); }
inline std::int64_t to_us(double seconds) { return std::llround(seconds * 1e6); }

}  // namespace autoref::league
