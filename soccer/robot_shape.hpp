// Dimensions of ball and robot according to the rules.
#pragma once

#include "soccer/geometry.hpp"
#include "soccer/units.hpp"

namespace autoref {

inline constexpr double kBallRadius_m = 21.5_mm;   // golf ball, diameter 43 mm (Laws 2014, law 2)
inline constexpr double kRobotRadius_m = 90_mm;    // cylinder of 180 mm diameter (paper, section 3)
inline constexpr double kRobotHeight_m = 147_mm;   // below the 150 mm of the paper, section 3
inline constexpr double kFrontDistance_m = 75_mm;  // from the centre to the flat kicker plate
inline constexpr double kHalfPlate_m = 0.049749371855331;  // sqrt(90^2 - 75^2) mm
inline constexpr double kDribblerZoneWidth_m = 80_mm;      // the part of the plate that kicks and
                                                           // dribbles

// Distance in metres from `point_m` to the outline of a robot at `centre_m` facing the unit vector
// `heading`. The outline is a disc of 90 mm radius, cut off flat 75 mm in front of its centre. The
// distance is negative inside.
double distance_to_hull(const Vec2& point_m, const Vec2& centre_m, const Vec2& heading);

// Whether the straight path from `a_m` to `b_m` intersects the hull of the robot at `centre_m`.
bool meets_hull(const Vec2& a_m, const Vec2& b_m, const Vec2& centre_m, const Vec2& heading);

}  // namespace autoref
