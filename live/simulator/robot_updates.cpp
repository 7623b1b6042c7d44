#include "live/simulator/robot_updates.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "league/simulator/packet_errors.hpp"
#include "soccer/colour.hpp"

namespace autoref::live {
namespace {

game::ChangedRobot changed_by(const league::SpecUpdate& update, game::ChangedRobot robot) {
  const double acceleration_mps2 = robot.acceleration_mps2;
  robot.mass_kg = update.mass_kg.value_or(robot.mass_kg);
  robot.speed_mps = update.speed_mps.value_or(robot.speed_mps);
  robot.acceleration_mps2 = update.acceleration_mps2.value_or(acceleration_mps2);
  robot.braking_mps2 = update.braking_mps2.value_or(robot.braking_mps2);
  robot.wheel_acceleration_mps2 *= robot.acceleration_mps2 / acceleration_mps2;
  robot.angular_speed_radps = update.angular_speed_radps.value_or(robot.angular_speed_radps);
  robot.angular_acceleration_radps2 =
      update.angular_acceleration_radps2.value_or(robot.angular_acceleration_radps2);
  robot.kick_limit_mps = update.kick_limit_mps.value_or(robot.kick_limit_mps);
  robot.chip_limit_mps = update.chip_limit_mps.value_or(robot.chip_limit_mps);
  return robot;
}

}  // namespace

void RobotUpdates::add(const std::vector<league::SpecUpdate>& updates,
                       std::vector<league::PacketError>& errors) {
  if (updates.empty()) return;
  const std::lock_guard lock(mutex_);
  if (is_closed_) {
    league::add_error(errors, "GAME_BEGUN", "robots can be changed only before the game");
    return;
  }
  for (const league::SpecUpdate& update : updates) add_one(update, errors);
}

void RobotUpdates::add_one(const league::SpecUpdate& update,
                           std::vector<league::PacketError>& errors) {
  const auto& [side, number] = update.robot;
  try {
    game::apply(changed_by(update, game::unchanged(update.robot, game_)), game_);
    is_changed_[side].set(static_cast<std::size_t>(number));
  } catch (const std::invalid_argument& error) {
    league::add_error(errors, "ROBOT_SPECS",
                      fmt::format("{} robot {}: {}", colour_of(side), number, error.what()));
  }
}

std::vector<game::ChangedRobot> RobotUpdates::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  std::vector<game::ChangedRobot> changed;
  changed.reserve(is_changed_[Side::kWest].count() + is_changed_[Side::kEast].count());
  for (const Side side : kSides) {
    for (int number = 0; number < kMaxRobots; ++number) {
      if (is_changed_[side].test(static_cast<std::size_t>(number)))
        changed.push_back(game::unchanged({side, number}, game_));
    }
  }
  return changed;
}

}  // namespace autoref::live
