#include "live/simulator/robot_updates.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "league/simulator/command_update.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/side.hpp"

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

// Rotates positions and velocities between the frame of vision and that of the world.
class Turn {
 public:
  explicit Turn(bool blue_on_positive_half) : blue_on_positive_half_(blue_on_positive_half) {}
  Vec2 operator()(const Vec2& vector) const { return published(vector, blue_on_positive_half_); }

  // The vector after replacing the coordinates that are given, in the frame of vision.
  Vec2 with(const std::optional<double>& x, const std::optional<double>& y,
            const Vec2& vector) const {
    const Vec2 seen = (*this)(vector);
    return (*this)(Vec2(x.value_or(seen.x()), y.value_or(seen.y())));
  }

 private:
  bool blue_on_positive_half_;
};

struct ChangeOf {
  const sim::WorldState& world;
  const Field& field;
  Turn turn;

  std::optional<game::WorldChange> operator()(const league::BallTeleport& teleport) const {
    sim::BallState ball = world.ball;
    ball.position_m = inside_walls(field, turn.with(teleport.x_m, teleport.y_m, ball.position_m));
    ball.velocity_mps = turn.with(teleport.vx_mps, teleport.vy_mps, ball.velocity_mps);
    ball.height_m = std::max(0.0, teleport.height_m.value_or(ball.height_m));
    ball.vertical_mps = teleport.vertical_mps.value_or(ball.vertical_mps);
    ball.is_rolling = teleport.rolls;
    return ball;
  }

  std::optional<game::WorldChange> operator()(const league::RobotTeleport& teleport) const {
    if (teleport.is_present == false) return game::RemovedRobot{teleport.robot};
    const auto& robots = world.robots[teleport.robot.side];
    const auto found = std::find_if(robots.begin(), robots.end(), [&](const sim::RobotState& one) {
      return one.number == teleport.robot.number;
    });
    if (found == robots.end() && !(teleport.x_m && teleport.y_m)) return std::nullopt;
    sim::RobotState state;
    state.number = teleport.robot.number;
    if (found != robots.end()) state = *found;
    state.position_m = inside_walls(field, turn.with(teleport.x_m, teleport.y_m, state.position_m));
    state.velocity_mps = turn.with(teleport.vx_mps, teleport.vy_mps, state.velocity_mps);
    if (teleport.heading_rad) state.heading = turn(heading_of(*teleport.heading_rad));
    state.angular_velocity_radps = teleport.angular_radps.value_or(state.angular_velocity_radps);
    return game::PlacedRobot{teleport.robot, state};
  }
};

}  // namespace

void RobotUpdates::add(const std::vector<league::SpecUpdate>& updates,
                       std::vector<league::PacketError>& errors) {
  if (updates.empty()) return;
  const std::lock_guard lock(mutex_);
  if (is_closed_) {
    league::add_error(errors, "GAME_BEGUN", "robots can only be changed before the game");
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

std::optional<game::WorldChange> change_of(const league::Teleport& teleport,
                                           const sim::WorldState& world, const Field& field,
                                           bool blue_on_positive_half) {
  return std::visit(ChangeOf{world, field, Turn(blue_on_positive_half)}, teleport);
}

}  // namespace autoref::live
