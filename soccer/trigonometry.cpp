#include "soccer/trigonometry.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/units.hpp"

namespace autoref {
namespace {

// The arctangent of x on [-tan(pi/8), tan(pi/8)], by the Chebyshev fit of (atan(x) / x - 1) / x^2
// of degree 10 in x^2; its error is 3e-18.
double atan_series(double x) {
  const double s = x * x;
  const double s2 = s * s;
  const double s4 = s2 * s2;
  const double low = (-0.3333333333333333 + s * 0.19999999999995521) +
                     s2 * (-0.14285714284666543 + s * 0.11111111015256362);
  const double middle = (-0.090909045781239019 + s * 0.076921831908260866) +
                        s2 * (-0.06664511447381948 + s * 0.058581489128022099);
  const double high = -0.050854497379402599 + s * 0.039231658295587191 + s2 * -0.019176887119062259;
  return x + x * s * (low + s4 * (middle + s4 * high));
}

constexpr double kLargest = 700;
constexpr double kLn2 = 0.693147180559945309;
constexpr int kTerms = 14;  // number of terms of the series; the next one is below 1e-18

}  // namespace

// Reduced to the first octant, `part` is the angle itself or, if that exceeds pi/8, the angle minus
// pi/4.
double atan2_exact(double y, double x) {
  constexpr double kTanOfHalf = 0.41421356237309503;  // tangent of half of pi/4
  const double across = std::abs(y);
  const double along = std::abs(x);
  const double low = std::min(across, along);
  const double high = std::max(across, along);
  if (high == 0.0) return 0.0;
  const bool is_steep = low > kTanOfHalf * high;
  const double part = is_steep ? atan_series((low - high) / (low + high)) : atan_series(low / high);
  double angle_rad = is_steep ? kPi / 4.0 + part : part;
  if (across > along) angle_rad = kPi / 2.0 - angle_rad;
  if (x < 0.0) angle_rad = kPi - angle_rad;
  return std::copysign(angle_rad, y);
}

double wrap_angle(double angle_rad) {
  if (angle_rad >= -kPi && angle_rad <= kPi) return angle_rad;
  return angle_rad - 2.0 * kPi * trigonometry::to_integer(angle_rad / (2.0 * kPi));
}

double exponential(double x) {
  const double limited = std::clamp(x, -kLargest, kLargest);
  // e^x = 2^doublings e^rest with |rest| <= ln(2) / 2.
  const double doublings = std::floor(limited / kLn2 + 0.5);
  const double rest = limited - doublings * kLn2;
  double sum = 1;
  for (int k = kTerms; k > 0; --k) sum = 1 + sum * rest / k;
  return std::ldexp(sum, static_cast<int>(doublings));
}

}  // namespace autoref
