// Cameras over the default field, and scenes in front of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sim/camera.hpp"
#include "sim/presets.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::sim {

inline Camera camera_of(const char* preset, std::uint64_t seed = 1) {
  Configuration configuration;
  apply_camera_preset(preset, configuration);
  return {configuration.vision, Field{}, 60, seed};
}

inline Field field_of(const char* book) { return find_game_setup(book)->field; }

inline VisionParameters vision_of(const char* preset) {
  Configuration configuration;
  apply_camera_preset(preset, configuration);
  return configuration.vision;
}

// Without noise, misses and false detections, with all cameras at the same time.
inline VisionParameters steady(const char* preset) {
  VisionParameters vision = vision_of(preset);
  vision.ball_noise_m = vision.robot_noise_m = vision.robot_noise_rad = 0;
  vision.ball_misses = vision.ball_misses_near_robots = 0;
  vision.robot_misses = vision.robot_gaps = 0;
  vision.cameras_run_freely = false;
  vision.false_balls_per_s = vision.misread_numbers = 0;
  vision.robots_hide_ball = false;
  return vision;
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
