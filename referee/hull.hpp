// How far a robot's hull reaches, and what may stand between what is seen and what is.
#pragma once

#include "referee/referee.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// How far the hull reaches from the robot's centre in the unit direction `way`, in metres.
double reach_of_hull_m(const Vec2& heading, const Vec2& way);

// Distance in metres from the hull to the defence area of `side`, negative once it is in it.
double hull_to_area_m(const Field& field, Side side, const RobotObservation& robot);

// By how much noise may put a robot wrong, or a distance between robot and ball, in metres: what is
// judged by a single picture must be beyond it. 0 where vision is exact.
double robot_doubt_m(const VisionNoise& noise);
double robot_to_ball_doubt_m(const VisionNoise& noise);

}  // namespace autoref::referee
