#include "soccer/robot_command.hpp"

#include <gtest/gtest.h>

#include <array>

namespace autoref {
namespace {

// Numbers that are not floats, computed when the test runs.
RobotCommand command_of(int number) {
  const double third = number / 3.0;
  return {Vec2(third, -2 * third), 4 * third, 5 * third, false, false};
}

void expect_float(double value) {
  const volatile auto rounded = static_cast<float>(value);
  EXPECT_EQ(value, static_cast<double>(rounded));
}

TEST(Transmitted, AllNumbersAreFloats) {
  TeamCommands commands{};
  for (int number = 0; number < kMaxRobots; ++number)
    commands.at(static_cast<std::size_t>(number)) = transmitted(command_of(number + 1));
  for (const RobotCommand& command : commands) {
    expect_float(command.velocity_mps.x());
    expect_float(command.velocity_mps.y());
    expect_float(command.angular_velocity_radps);
    expect_float(command.kick_mps);
  }
}

}  // namespace
}  // namespace autoref
