#include "soccer/trigonometry.hpp"

#include <cmath>
#include <cstdint>

#include "soccer/units.hpp"

namespace autoref {
namespace {

// pi/2 split in two (Cody and Waite): the high part has 33 bits, so its product with a small
// integer is exact.
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;

// Taylor series on [-pi/4, pi/4] in Horner's form; the first omitted term is below 1e-17.
double sin_series(double x) {
  const double s = x * x;
  double sum = 1.0 / 355687428096000.0;
  sum = sum * s - 1.0 / 1307674368000.0;
  sum = sum * s + 1.0 / 6227020800.0;
  sum = sum * s - 1.0 / 39916800.0;
  sum = sum * s + 1.0 / 362880.0;
  sum = sum * s - 1.0 / 5040.0;
  sum = sum * s + 1.0 / 120.0;
  sum = sum * s - 1.0 / 6.0;
  return x + x * s * sum;
}

double cos_series(double x) {
  const double s = x * x;
  double sum = 1.0 / 20922789888000.0;
  sum = sum * s - 1.0 / 87178291200.0;
  sum = sum * s + 1.0 / 479001600.0;
  sum = sum * s - 1.0 / 3628800.0;
  sum = sum * s + 1.0 / 40320.0;
  sum = sum * s - 1.0 / 720.0;
  sum = sum * s + 1.0 / 24.0;
  sum = sum * s - 1.0 / 2.0;
  return 1.0 + s * sum;
}

}  // namespace

// Reduces the angle to the nearest multiple of pi/2; that multiple modulo 4 is the quadrant.
SinCos sin_cos(double angle_rad) {
  const double quarters = std::nearbyint(angle_rad * (2.0 / kPi));
  const double rest = (angle_rad - quarters * kHalfPiHigh) - quarters * kHalfPiLow;
  const double s = sin_series(rest);
  const double c = cos_series(rest);
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double atan2_exact(double y, double x) {
  if (x == 0.0 && y == 0.0) return 0.0;
  // Initial guess in single precision (atan2f has a single implementation for all processors), then
  // one Newton step: the remaining angle is so small that it equals its sine.
  const double guess = atan2f(static_cast<float>(y), static_cast<float>(x));
  const auto [s, c] = sin_cos(guess);
  return wrap_angle(guess + (y * c - x * s) / (x * c + y * s));
}

double wrap_angle(double angle_rad) {
  if (angle_rad >= -kPi && angle_rad <= kPi) return angle_rad;
  return angle_rad - 2.0 * kPi * std::nearbyint(angle_rad / (2.0 * kPi));
}

}  // namespace autoref
