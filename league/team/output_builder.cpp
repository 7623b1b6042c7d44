#include "league/team/output_builder.hpp"

#include <fmt/format.h>

#include <cmath>

#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

void check_number(std::string_view what, std::int64_t number, int lowest) {
  if (number >= lowest && number < kMaxRobots) return;
  throw TeamFault(
      fmt::format("{} is {}; it must be from {} to {}", what, number, lowest, kMaxRobots - 1));
}

void check_value(std::int64_t robot, std::string_view name, double value, double low, double high) {
  if (!std::isfinite(value)) {
    throw TeamFault(fmt::format("{} of robot {} is {}; it must be finite", name, robot, value));
  }
  if (value >= low && value <= high) return;
  throw TeamFault(
      fmt::format("{} of robot {} is {}; it must be from {} to {}", name, robot, value, low, high));
}

}  // namespace

OutputBuilder::OutputBuilder(TeamOutput& output) : output_(&output) {
  output.frame = 0;
  output.commands.fill(RobotCommand{});
  output.requests = {};
  output.text.clear();
}

void OutputBuilder::set_frame(std::int64_t frame) {
  if (frame < 0) throw TeamFault(fmt::format("frame is {}; it must not be negative", frame));
  output_->frame = frame;
}

void OutputBuilder::set_keeper(std::int64_t number) {
  check_number("keeper", number, -1);
  output_->requests.keeper = static_cast<int>(number);
}

void OutputBuilder::set_leaves(std::int64_t number) {
  check_number("leaves", number, 0);
  output_->requests.leaves = static_cast<int>(number);
}

void OutputBuilder::set_text(std::string_view text) {
  if (text.size() > kLongestOutputText) {
    throw TeamFault(
        fmt::format("text has {} bytes; the limit is {}", text.size(), kLongestOutputText));
  }
  output_->text = text;
}

void OutputBuilder::add_command(std::int64_t robot, const RobotCommand& command) {
  check_number("robot", robot, 0);
  const auto index = static_cast<std::size_t>(robot);
  if (commanded_[index]) throw TeamFault(fmt::format("robot {} has two commands", robot));
  commanded_.set(index);
  check_value(robot, "vx_mps", command.velocity_mps.x(), -kFastest_mps, kFastest_mps);
  check_value(robot, "vy_mps", command.velocity_mps.y(), -kFastest_mps, kFastest_mps);
  check_value(robot, "angular_velocity_radps", command.angular_velocity_radps, -kFastest_radps,
              kFastest_radps);
  check_value(robot, "kick_mps", command.kick_mps, 0, kFastest_mps);
  output_->commands[index] = command;
}

}  // namespace autoref::league
