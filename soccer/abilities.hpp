// What a robot can do.
#pragma once

namespace autoref {

// What one of a team's robots can do, including its handicap. The defaults are the paper's robots.
struct Abilities {
  double speed_mps = 3.0;
  double acceleration_mps2 = 3.0;
  double braking_mps2 = 5.0;
  double kick_mps = 8.0;
  double chip_mps = 5.5;
};

}  // namespace autoref
