// What a team sends to its robots once per frame.
#pragma once

#include <array>
#include <cmath>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref {

// One robot's commands. Velocities are in the robot's own frame: x forward, y to its left.
struct RobotCommand {
  Vec2 velocity_mps{0, 0};
  double angular_velocity_radps = 0;
  double kick_mps = 0;  // speed over ground once the ball is in the dribbler zone; 0: no kick
  bool chip = false;    // kick upwards at 45 degrees
  bool dribble = false;
};

inline bool is_finite(const RobotCommand& c) {
  return is_finite(c.velocity_mps) && std::isfinite(c.angular_velocity_radps) &&
         std::isfinite(c.kick_mps);
}

// The command as it travels to a robot: in floats, without negative zeros.
inline RobotCommand transmitted(const RobotCommand& c) {
  // Volatile: when GCC 12 makes vectors of two such conversions, it takes them for the identity.
  const auto as_float = [](double value) {
    const volatile auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) + 0.0;
  };
  return {Vec2(as_float(c.velocity_mps.x()), as_float(c.velocity_mps.y())),
          as_float(c.angular_velocity_radps), as_float(c.kick_mps), c.chip, c.dribble};
}

// Commands of a side, by robot number. A robot without a new command stands still.
using TeamCommands = std::array<RobotCommand, kMaxRobots>;

}  // namespace autoref
