// Trigonometry and the exponential function with bit-identical results on every x86-64 machine.
//
// The C library uses different code for sin, cos and atan2 on machines with fused multiply-add,
// which changes the last bit of the result. A game with the same seed would then end differently on
// another host. These functions use only additions, multiplications and divisions, which IEEE 754
// defines exactly. All angles are in radians.
#pragma once

#include <cstdint>

#include "soccer/units.hpp"

namespace autoref {

struct SinCos {
  double sin;
  double cos;
};

// Details; only for the functions below.
namespace trigonometry {

// pi/2 split in two (Cody and Waite): the high part has 33 bits, so its product with a small
// integer is exact.
inline constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
inline constexpr double kHalfPiLow = 6.07710050650619224932e-11;

// Adding and subtracting this rounds to the nearest integer.
inline constexpr double kRounder = 6755399441055744.0;  // 1.5 * 2^52

inline double to_integer(double x) { return (x + kRounder) - kRounder; }

// Polynomials in s = x^2 are evaluated in pairs (Estrin's scheme), which a processor computes side
// by side. Both series are Taylor series on [-pi/4, pi/4]; the first omitted term is below 1e-17.
inline double sin_series(double x) {
  const double s = x * x;
  const double s2 = s * s;
  const double low = (1.0 / 120.0 - s * (1.0 / 5040.0)) * s - 1.0 / 6.0;
  const double middle = 1.0 / 362880.0 - s * (1.0 / 39916800.0);
  const double high =
      1.0 / 6227020800.0 - s * (1.0 / 1307674368000.0) + s2 * (1.0 / 355687428096000.0);
  return x + x * s * (low + s * s2 * (middle + s2 * high));
}

inline double cos_series(double x) {
  const double s = x * x;
  const double s2 = s * s;
  const double low = 1.0 / 24.0 - s * (1.0 / 720.0);
  const double middle = 1.0 / 40320.0 - s * (1.0 / 3628800.0);
  const double high = 1.0 / 479001600.0 - s * (1.0 / 87178291200.0) + s2 * (1.0 / 20922789888000.0);
  return 1.0 - s / 2.0 + s2 * (low + s2 * (middle + s2 * high));
}

}  // namespace trigonometry

// Sine and cosine of `angle_rad`, within 4e-16 of the exact value for |angle_rad| <= 1e5. Inline,
// since games call it more than any other function. The function subtracts the nearest multiple of
// pi/2 from the angle. That multiple modulo 4 is the quadrant.
inline SinCos sin_cos(double angle_rad) {
  const double quarters = trigonometry::to_integer(angle_rad * (2.0 / kPi));
  const double rest =
      (angle_rad - quarters * trigonometry::kHalfPiHigh) - quarters * trigonometry::kHalfPiLow;
  const double series[] = {trigonometry::sin_series(rest), trigonometry::cos_series(rest)};
  // A table avoids branches, which a processor could not predict.
  constexpr double kSigns[] = {1.0, -1.0};
  const auto quadrant = static_cast<std::uint64_t>(static_cast<std::int64_t>(quarters));
  const std::uint64_t swaps = quadrant & 1;
  return {series[swaps] * kSigns[quadrant >> 1 & 1],
          series[swaps ^ 1] * kSigns[(quadrant + 1) >> 1 & 1]};
}

// The angle of the vector (x, y) in [-pi, pi], accurate to 1e-15; 0 for the zero vector.
double atan2_exact(double y, double x);

// `angle_rad` shifted by a multiple of 2 pi into [-pi, pi].
double wrap_angle(double angle_rad);

// e^x, with a relative error below 1e-12 for |x| <= 700; beyond that, the value at the nearest such
// x.
double exponential(double x);

}  // namespace autoref
