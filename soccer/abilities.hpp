// What a robot can do.
#pragma once

namespace autoref {

// What one of a team's robots can do, including its handicap. The defaults are the paper's robots.
struct Abilities {
  double speed_mps = 3.0;  // paper, section 3: up to 3 m/s
  double acceleration_mps2 = 3.0;
  double braking_mps2 = 5.0;
  double kick_mps = 8.0;  // paper, section 3
  double chip_mps = 5.5;
};

// The same for robots in general: what teams assume of them, and the simulator's defaults.
inline constexpr Abilities kUsualAbilities;
inline constexpr double kUsualTurning_radps2 = 40;  // angular acceleration
// Standard deviations of a kick: of its direction, and of its speed as a fraction.
inline constexpr double kUsualKickError_deg = 1.5;
inline constexpr double kUsualKickSpeedError = 0.025;

}  // namespace autoref
