// A change of the world from outside of a game.
#pragma once

#include <variant>

#include "game/loop/game.hpp"
#include "sim/world.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

struct PlacedRobot {
  RobotId robot;
  sim::RobotState state;
};

struct RemovedRobot {
  RobotId robot;
};

using WorldChange = std::variant<sim::BallState, PlacedRobot, RemovedRobot>;

// Changes the world between two steps. A robot that is off the field returns to it if there is room
// where it is placed; otherwise nothing changes.
void apply(const WorldChange& change, Game& game);

}  // namespace autoref::game
