// Where a robot's hull lies in or before a defence area, whose lines belong to it.
#pragma once

#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// Distance in metres from the hull to the defence area of `side`; negative where it is partly
// inside, by how far it reaches in.
double hull_to_area_m(const Field& field, Side side, const RobotObservation& robot);

// How far in metres the hull reaches out of that area into the field; negative where it is entirely
// inside. As in soccer/field.hpp, the area goes on behind the goal line.
double hull_out_of_area_m(const Field& field, Side side, const RobotObservation& robot);

}  // namespace autoref::referee
