// Changes made to a game from outside: to its world while it is played, and to its robots' limits
// before it.
#pragma once

#include <variant>

#include "game/loop/game.hpp"
#include "game/loop/game_configuration.hpp"
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

// Changes the world between two steps. A robot that is off the field returns if there is room at
// its new position; otherwise nothing changes.
void apply(const WorldChange& change, Game& game);

// A robot with limits that a program on the network has set before the game.
struct ChangedRobot {
  RobotId robot;
  double mass_kg = 0;
  double speed_mps = 0;
  double acceleration_mps2 = 0;
  double braking_mps2 = 0;
  double wheel_acceleration_mps2 = 0;
  double angular_speed_radps = 0;
  double angular_acceleration_radps2 = 0;
  double kick_limit_mps = 0;
  double chip_limit_mps = 0;
};

// The robot with the limits that it has in `game`.
ChangedRobot unchanged(RobotId robot, const GameConfiguration& game);

// Sets the robot's limits. Throws std::invalid_argument, and changes nothing, if a limit is out of
// range or the robot does not exist.
void apply(const ChangedRobot& changed, GameConfiguration& game);

}  // namespace autoref::game
