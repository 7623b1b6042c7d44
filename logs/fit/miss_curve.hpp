// How often the ball is missed, as a function of its distance from the nearest robot.
#pragma once

#include <span>

namespace autoref::logs {

// Frames with a ball at about the same gap to the nearest robot.
struct GapBin {
  double frames = 0;
  double missed = 0;
  double sum_m = 0;  // of the gaps
};

// The probability of a miss is 1 - (1 - far) (1 - near exp(-gap / near_m)).
struct MissCurve {
  double far = 0;
  double near = 0;
  double near_m = 0;
};

// The curve with the maximum likelihood. Its result is only meaningful if there are frames both
// near robots and far from them.
MissCurve fitted_miss_curve(std::span<const GapBin> bins);

}  // namespace autoref::logs
