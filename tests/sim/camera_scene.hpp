// Cameras over the default field, and scenes in front of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sim/camera.hpp"
#include "sim/presets.hpp"

namespace autoref::sim {

inline Camera camera_of(const char* preset, std::uint64_t seed = 1) {
  Configuration configuration;
  apply_camera_preset(preset, configuration);
  return {configuration.vision, Field{}, 60, seed};
}

inline WorldState world_with_robot_at(const Vec2& robot_m, const Vec2& ball_m) {
  WorldState world;
  world.robots[Side::kEast].push_back({});
  world.robots[Side::kEast][0].position_m = robot_m;
  world.ball.position_m = ball_m;
  return world;
}

// Positions from wall to wall, `steps` on either side of the centre in each direction.
inline std::vector<Vec2> grid_within_walls(const Field& field, int steps) {
  std::vector<Vec2> positions_m;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j)
      positions_m.emplace_back(field.wall_x_m() * i / steps, field.wall_y_m() * j / steps);
  }
  return positions_m;
}

inline std::string name_of_camera_preset(const testing::TestParamInfo<const char*>& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace autoref::sim
