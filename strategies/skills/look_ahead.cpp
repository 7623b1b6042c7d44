#include "strategies/skills/look_ahead.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/prediction.hpp"
#include "strategies/skills/strike.hpp"

namespace autoref::strategies {
namespace {

constexpr double kWholeFrame = 1e-6;  // a smaller part of a frame is a rounding error

// Moves the robot for `duration_s` towards the command's velocity, with the accelerations that it
// is capable of (sim/drive.hpp).
void obey(const RobotCommand& command, const Abilities& abilities, double duration_s,
          TrackedRobot& robot) {
  const Vec2 wanted_mps = clamp_norm(command.velocity_mps, abilities.speed_mps);
  const Vec2 error_mps = to_world(wanted_mps, robot.heading) - robot.velocity_mps;
  const double limit_mps2 =
      robot.velocity_mps.dot(error_mps) < 0 ? abilities.braking_mps2 : abilities.acceleration_mps2;
  const Vec2 change_mps = clamp_norm(error_mps, limit_mps2 * duration_s);
  const double most_radps = kUsualTurning_radps2 * duration_s;
  const double change_radps = std::clamp(
      command.angular_velocity_radps - robot.angular_velocity_radps, -most_radps, most_radps);
  // Constant acceleration: the mean of the velocities before and after.
  robot.position_m += (robot.velocity_mps + change_mps / 2) * duration_s;
  const double turn_rad = (robot.angular_velocity_radps + change_radps / 2) * duration_s;
  // Accurate to second order in the angle; the length is corrected at the end.
  robot.heading = robot.heading * (1 - turn_rad * turn_rad / 2) + left_of(robot.heading) * turn_rad;
  robot.velocity_mps += change_mps;
  robot.angular_velocity_radps += change_radps;
}

}  // namespace

LookAhead::LookAhead(const TeamAbilities& abilities, double frame_rate_hz)
    : abilities_(abilities), frame_s_(1 / frame_rate_hz) {}

void LookAhead::note(std::int64_t frame, const TeamCommands& commands) {
  Sent& sent = sent_[static_cast<std::size_t>(frame) % sent_.size()];
  sent.frame = frame;
  sent.commands = commands;
}

const TeamCommands* LookAhead::sent_for(std::int64_t frame) const {
  if (frame < 0) return nullptr;
  const Sent& sent = sent_[static_cast<std::size_t>(frame) % sent_.size()];
  return sent.frame == frame ? &sent.commands : nullptr;
}

// The commands of a frame take effect `delay` frames later and last for one frame. So the commands
// of the last `delay` frames have not yet taken effect, or only in part for the first of them.
LookAhead::Pending LookAhead::pending(const TeamView& view) const {
  Pending all;
  const double delay = view.latency_s / frame_s_;
  const int frames = std::min(static_cast<int>(std::ceil(delay - kWholeFrame)), kKept);
  for (int age = frames; age >= 1; --age) {
    const double share = age == frames ? delay - (frames - 1) : 1.0;
    all.push_back({sent_for(view.frame - age), share * frame_s_});
  }
  return all;
}

void LookAhead::follow(const Pending& pending, TrackedRobot& robot) const {
  const auto number = static_cast<std::size_t>(robot.number);
  RobotCommand command;  // the robot continues its current motion
  command.velocity_mps = to_local(robot.velocity_mps, robot.heading);
  command.angular_velocity_radps = robot.angular_velocity_radps;
  for (const auto& [sent, duration_s] : pending) {
    if (sent != nullptr) command = (*sent)[number];
    obey(command, abilities_[number], duration_s, robot);
  }
  robot.heading = direction_of(robot.heading, Vec2(1, 0));
}

bool LookAhead::look(const TeamView& view, TeamView& ahead) const {
  look_ahead(view, ahead);
  const Pending commands = pending(view);
  const TeamCommands* last = sent_for(view.frame - 1);
  bool is_held = false;
  for (std::size_t i = 0; i < view.own.size(); ++i) {
    ahead.own[i] = view.own[i];
    follow(commands, ahead.own[i]);
    if (is_held || !last || !(*last)[static_cast<std::size_t>(view.own[i].number)].dribble)
      continue;
    if (!has_ball(view.own[i], view.ball.position_m)) continue;
    is_held = true;
    const Vec2 arm_m = to_local(view.ball.position_m - view.own[i].position_m, view.own[i].heading);
    ahead.ball.position_m = ahead.own[i].position_m + to_world(arm_m, ahead.own[i].heading);
    ahead.ball.velocity_mps = plate_mps(ahead.own[i]);
  }
  return is_held;
}

}  // namespace autoref::strategies
