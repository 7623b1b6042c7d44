// Robot poses before the game.
#pragma once

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::sim {

// The pose of a robot: in a row in its own half, along the touch line to the right of its keeper,
// facing the opponents' goal. This is not a formation, so teams have to move. The two sides'
// positions are 180-degree rotations of each other.
BodyState pose_in_line_up(const Field& field, const LineUpParameters& line_up, RobotId id);

}  // namespace autoref::sim
