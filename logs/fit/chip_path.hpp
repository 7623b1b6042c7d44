// The flight and bounces of a chipped ball.
#pragma once

#include <optional>

#include "logs/fit/estimate.hpp"
#include "logs/fit/kick_solver.hpp"

namespace autoref::logs {

// A chip kick up to its first landing or beyond.
struct Chip {
  Measured angle_deg;  // elevation of the kick
  Measured first_xy;   // fractions of speed kept at landings, as in sim::BallParameters
  std::optional<Measured> first_z;
  std::optional<Measured> later_xy;
};

struct ChipPath {
  double landing_s = 0;      // since the last detection before the kick
  std::optional<Chip> chip;  // nullopt if the first bounce is not seen well
};

// The path of `ball` if it flies: the path of a flying and bouncing ball explains what the cameras
// report, and that of a ball which slides and rolls on the carpet explains it much worse. Otherwise
// nullopt.
std::optional<ChipPath> chip_path_of(const KickedBall& ball);

}  // namespace autoref::logs
