// Where a game begins, if not with both teams lined up before the first kick-off.
#pragma once

#include <boost/container/static_vector.hpp>

#include "referee/beginning.hpp"
#include "sim/world.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

using StartingRobots = boost::container::static_vector<sim::RobotState, kMaxRobots>;

// In the program's coordinates: west defends the goal at -x.
struct StartState {
  PerSide<StartingRobots> robots;  // by number; a team's other robots stay off the field
  sim::BallState ball;
  referee::Beginning referee;
};

// The state seen from the other end: rotated by 180 degrees, with the sides swapped.
StartState mirrored(const StartState& state);

}  // namespace autoref::game
