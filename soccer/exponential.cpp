#include "soccer/exponential.hpp"

#include <algorithm>
#include <cmath>

namespace autoref {
namespace {

constexpr double kLargest = 700;
constexpr double kLn2 = 0.693147180559945309;
constexpr int kTerms = 14;  // of the series; the next is below 1e-18

}  // namespace

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
