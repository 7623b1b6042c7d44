// Where the robots stand before the game.
#pragma once

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::sim {

// In a row in the own half, along the touch line to the right of the side's goal keeper, facing
// the opponents' goal: no formation, so that teams have to move. The sides' places are each
// other's, turned by 180 degrees.
BodyState pose_in_line_up(const Field& field, const LineUpParameters& line_up, RobotId id);

}  // namespace autoref::sim
