// Cameras over the default field, and scenes in front of them.
#pragma once

#include "sim/camera.hpp"
#include "sim/camera_presets.hpp"

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

}  // namespace autoref::sim
