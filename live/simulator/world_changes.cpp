#include "live/simulator/world_changes.hpp"

#include <algorithm>

#include "soccer/published.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::live {
namespace {

// Positions and velocities turn alike between the frames of vision and of the world.
class Turn {
 public:
  explicit Turn(bool blue_on_positive_half) : blue_on_positive_half_(blue_on_positive_half) {}
  Vec2 operator()(const Vec2& vector) const { return published(vector, blue_on_positive_half_); }

  // The vector with the coordinates that are given in the frame of vision.
  Vec2 with(const std::optional<double>& x, const std::optional<double>& y,
            const Vec2& vector) const {
    const Vec2 seen = (*this)(vector);
    return (*this)(Vec2(x.value_or(seen.x()), y.value_or(seen.y())));
  }

 private:
  bool blue_on_positive_half_;
};

Vec2 inside_walls(const Vec2& position_m, const Field& field) {
  const double x_m = field.wall_x_m() - kRobotRadius_m;
  const double y_m = field.wall_y_m() - kRobotRadius_m;
  return {std::clamp(position_m.x(), -x_m, x_m), std::clamp(position_m.y(), -y_m, y_m)};
}

struct ChangeOf {
  const sim::WorldState& world;
  const Field& field;
  Turn turn;

  std::optional<game::WorldChange> operator()(const league::BallTeleport& teleport) const {
    sim::BallState ball = world.ball;
    ball.position_m = inside_walls(turn.with(teleport.x_m, teleport.y_m, ball.position_m), field);
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
    state.position_m = inside_walls(turn.with(teleport.x_m, teleport.y_m, state.position_m), field);
    state.velocity_mps = turn.with(teleport.vx_mps, teleport.vy_mps, state.velocity_mps);
    if (teleport.heading_rad) state.heading = turn(heading_of(*teleport.heading_rad));
    state.angular_velocity_radps = teleport.angular_radps.value_or(state.angular_velocity_radps);
    return game::PlacedRobot{teleport.robot, state};
  }
};

}  // namespace

std::optional<game::WorldChange> change_of(const league::Teleport& teleport,
                                           const sim::WorldState& world, const Field& field,
                                           bool blue_on_positive_half) {
  return std::visit(ChangeOf{world, field, Turn(blue_on_positive_half)}, teleport);
}

}  // namespace autoref::live
