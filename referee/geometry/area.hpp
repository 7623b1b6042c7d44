// Where a robot's hull lies relative to a defence area. The area includes its lines.
#pragma once

#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// Distance in metres from the hull to the defence area of `side`; if the hull is partly inside,
// minus the depth of the hull in the area.
double hull_to_area_m(const Field& field, Side side, const RobotObservation& robot);

// How far, in metres, the hull extends from the defence area into the field; negative if the hull
// is entirely inside. As in soccer/field.hpp, the area continues behind the goal line.
double hull_out_of_area_m(const Field& field, Side side, const RobotObservation& robot);

}  // namespace autoref::referee
