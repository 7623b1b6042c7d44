// Sets robots and ball to other positions, as programs that control a simulator ask for it.
#pragma once

#include <optional>
#include <variant>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

// In the frame of vision. What is not set stays as it is.
struct BallTeleport {
  std::optional<double> x_m;
  std::optional<double> y_m;
  std::optional<double> height_m;
  std::optional<double> vx_mps;
  std::optional<double> vy_mps;
  std::optional<double> vertical_mps;
  bool rolls = false;  // the ball rolls at once, without sliding first
};

struct RobotTeleport {
  RobotId robot;  // west is yellow
  std::optional<double> x_m;
  std::optional<double> y_m;
  std::optional<double> heading_rad;
  std::optional<double> vx_mps;
  std::optional<double> vy_mps;
  std::optional<double> angular_radps;
  std::optional<bool> is_present;  // whether the robot is on the field
};

using Teleport = std::variant<BallTeleport, RobotTeleport>;

}  // namespace autoref::league
