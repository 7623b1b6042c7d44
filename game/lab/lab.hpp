// The laboratory: small experiments with robots and ball but without teams or referee.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::game {

// A command that replaces the robot's previous one from `at_s` on. Within `over_s`, the speeds
// change linearly from those of the previous command to those of this one.
struct TimedCommand {
  double at_s = 0;
  double over_s = 0;
  RobotCommand command;
};

struct LabRobot {
  RobotId id;  // numbered per side from 0, in the order of the file
  sim::RobotSpec spec;
  sim::RobotState start;
  std::vector<TimedCommand> commands;  // the robot's commands in order of time
};

// Motors, kickers, camera and radio are exact and without delay unless the scene says otherwise.
struct LabScene {
  LabScene();

  std::string about;
  double duration_s = 1;
  Field field;
  sim::Configuration sim;
  sim::RobotSpec robot;  // spec of robots without a type
  std::uint64_t seed = 1;
  sim::BallState ball;
  std::vector<LabRobot> robots;
};

// The states of the world at the start and after each camera frame.
struct LabRecord {
  double frame_rate_hz = 60;
  std::vector<sim::WorldState> states;
};

// Reads a scene as strictly as a scenario. Throws InputError with file, line and key.
LabScene read_lab_scene(const std::filesystem::path& file);
LabScene read_lab_scene_text(const std::string& text, const std::string& file_name);

// Simulates the scene. Each command takes effect `sim.latency_s` after its `at_s`.
LabRecord play_lab_scene(const LabScene& scene);

// One row per frame: time, then position, heading and speed of every object, in SI units, headings
// in degrees. Robots are named by side and number, such as west0.
std::string csv_of(const LabScene& scene, const LabRecord& record);

}  // namespace autoref::game
