// A robot's abilities, and what a team sends to its robots and requests of the referee in each
// frame.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref {

// The abilities of one of a team's robots, including its handicap. The defaults are those of the
// paper's robots.
struct Abilities {
  double speed_mps = 3.0;  // paper, section 3: up to 3 m/s
  double acceleration_mps2 = 3.0;
  double braking_mps2 = 5.0;
  double kick_mps = 8.0;  // paper, section 3
  double chip_mps = 5.5;
};

// The abilities of a usual robot. Teams assume them, and they are the simulator's defaults.
inline constexpr Abilities kUsualAbilities;
inline constexpr double kUsualTurning_radps2 = 40;  // angular acceleration
// Standard deviations of a kick's direction and of its speed, the latter as a fraction of the
// speed.
inline constexpr double kUsualKickError_deg = 1.5;
inline constexpr double kUsualKickSpeedError = 0.025;

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
  // Volatile, because GCC 12 mistakes two such conversions for the identity when it vectorises
  // them.
  const auto as_float = [](double value) {
    const volatile auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) + 0.0;
  };
  return {Vec2(as_float(c.velocity_mps.x()), as_float(c.velocity_mps.y())),
          as_float(c.angular_velocity_radps), as_float(c.kick_mps), c.chip, c.dribble};
}

// Commands for one side's robots, by robot number. A robot without a new command stands still.
using TeamCommands = std::array<RobotCommand, kMaxRobots>;

// The requests that a team can make to the referee.
struct TeamRequests {
  int keeper = 0;             // number of the robot that acts as keeper; -1: unknown
  std::optional<int> leaves;  // the robot to remove first after a card
  bool timeout = false;       // requested for as long as it is set; takes effect once play is
                              // stopped
};

}  // namespace autoref
