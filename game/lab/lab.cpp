#include "game/lab/lab.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/csv.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::game {
namespace {

constexpr double kLabSameTime_s = 1e-9;

// The command `timed` at `time_s`, interpolated from the speeds of the `former` command.
RobotCommand eased(const TimedCommand& timed, const RobotCommand& former, double time_s) {
  RobotCommand command = timed.command;
  if (time_s + kLabSameTime_s >= timed.at_s + timed.over_s) return command;
  // Ramps linearly from the speeds of the former command.
  const double left = 1.0 - (time_s - timed.at_s) / timed.over_s;
  command.velocity_mps += left * (former.velocity_mps - command.velocity_mps);
  command.angular_velocity_radps +=
      left * (former.angular_velocity_radps - command.angular_velocity_radps);
  return command;
}

// The command in force for frames taken at `time_s`.
RobotCommand command_at(const LabRobot& robot, double time_s) {
  RobotCommand command;
  RobotCommand former;
  for (const TimedCommand& timed : robot.commands) {
    if (timed.at_s > time_s + kLabSameTime_s) break;
    command = eased(timed, former, time_s);
    former = timed.command;
  }
  return command;
}

PerSide<TeamCommands> commands_at(const LabScene& scene, double time_s) {
  PerSide<TeamCommands> commands{};
  for (const LabRobot& robot : scene.robots) {
    commands[robot.id.side][static_cast<std::size_t>(robot.id.number)] = command_at(robot, time_s);
  }
  return commands;
}

sim::World world_of(const LabScene& scene) {
  PerSide<sim::TeamSpec> specs;
  for (const LabRobot& robot : scene.robots) specs[robot.id.side].robots.push_back(robot.spec);
  sim::World world(scene.field, scene.sim, specs, scene.seed);
  for (const LabRobot& robot : scene.robots) world.put_robot(robot.id, robot.start);
  world.put_ball(scene.ball);
  return world;
}

std::string name_of(RobotId id) {
  return fmt::format("{}{}", autoref::name_of(id.side), id.number);
}

std::vector<std::string> columns_of(const LabScene& scene) {
  std::vector<std::string> columns = {"time_s",        "ball_x_m",       "ball_y_m",
                                      "ball_height_m", "ball_vx_mps",    "ball_vy_mps",
                                      "ball_vz_mps",   "ball_speed_mps", "ball_rolls"};
  for (const LabRobot& robot : scene.robots) {
    for (const char* quantity :
         {"x_m", "y_m", "heading_deg", "vx_mps", "vy_mps", "speed_mps", "turn_radps"}) {
      columns.push_back(name_of(robot.id) + "_" + quantity);
    }
  }
  return columns;
}

// Formats the value with more digits than the league can measure, but few enough for the text to be
// the same with every compiler.
std::string cell(double value) {
  const std::string text = fmt::format("{:.6f}", value);
  return text == "-0.000000" ? "0.000000" : text;
}

std::string row_of(const LabScene& scene, double time_s, const sim::WorldState& state) {
  const sim::BallState& ball = state.ball;
  std::vector<std::string> cells;
  for (const double value :
       {time_s, ball.position_m.x(), ball.position_m.y(), ball.height_m, ball.velocity_mps.x(),
        ball.velocity_mps.y(), ball.vertical_mps, ball.velocity_mps.norm()}) {
    cells.push_back(cell(value));
  }
  cells.emplace_back(ball.is_rolling ? "1" : "0");
  for (const LabRobot& of : scene.robots) {
    const sim::RobotState& robot = state.robots[of.id.side][static_cast<std::size_t>(of.id.number)];
    for (const double value :
         {robot.position_m.x(), robot.position_m.y(), angle_of(robot.heading) * 180.0 / kPi,
          robot.velocity_mps.x(), robot.velocity_mps.y(), robot.velocity_mps.norm(),
          robot.angular_velocity_radps}) {
      cells.push_back(cell(value));
    }
  }
  return io::csv_line(cells);
}

}  // namespace

LabScene::LabScene() {
  sim.latency_s = 0;
  robot.body.speed_noise = 0;
  robot.kicker.speed_noise = 0;
  robot.kicker.direction_noise_deg = 0;
}

LabRecord play_lab_scene(const LabScene& scene) {
  sim::World world = world_of(scene);
  LabRecord record{scene.sim.frame_rate_hz, {world.state()}};
  // As in a game, the latency is split: vision is delayed by whole frames, the radio link by the
  // remaining sub-steps.
  const int old_frames = sim::split_latency(scene.sim).frames;
  const auto frames = static_cast<int>(std::lround(scene.duration_s * scene.sim.frame_rate_hz));
  for (int f = 0; f < frames; ++f) {
    world.step(commands_at(scene, (f - old_frames) / scene.sim.frame_rate_hz), std::nullopt);
    record.states.push_back(world.state());
  }
  return record;
}

std::string csv_of(const LabScene& scene, const LabRecord& record) {
  std::string text = io::csv_line(columns_of(scene)) + "\n";
  for (std::size_t f = 0; f < record.states.size(); ++f) {
    const double time_s = static_cast<double>(f) / record.frame_rate_hz;
    text += row_of(scene, time_s, record.states[f]) + "\n";
  }
  return text;
}

}  // namespace autoref::game
