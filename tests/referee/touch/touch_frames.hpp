// Shared by tests of touch detection: their frames and the ball's distance at a touch.
#pragma once

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

inline constexpr double kFrame_s = 1.0 / 60;
inline constexpr double kTouch_m =
    kFrontDistance_m + kBallRadius_m;  // centre to centre, at the plate

}  // namespace autoref::referee
