#include "sim/camera.hpp"

#include <stdexcept>

#include "soccer/trigonometry.hpp"

namespace autoref::sim {
namespace {

double as_float_mm(double metres) {
  return static_cast<double>(static_cast<float>(metres * 1000.0)) / 1000.0;
}

Vec2 rounded(const Vec2& position_m) {
  return {as_float_mm(position_m.x()), as_float_mm(position_m.y())};
}

Vec2 rounded_heading(const Vec2& heading) {
  return heading_of(static_cast<double>(static_cast<float>(angle_of(heading))));
}

}  // namespace

CameraParameters camera_preset(std::string_view name) {
  if (name == "paper") return {};
  throw std::invalid_argument("unknown camera preset '" + std::string(name) + "'; known: paper");
}

std::vector<std::string> camera_preset_names() { return {"paper"}; }

Camera::Camera(const CameraParameters& parameters, double frame_rate_hz)
    : parameters_(parameters), frame_rate_hz_(frame_rate_hz) {}

void Camera::look(const WorldState& world, Frame& frame) const {
  frame.number = world.frame;
  frame.time_s = static_cast<double>(world.frame) / frame_rate_hz_;
  for (Side side : kSides) {
    frame.robots[side].clear();
    for (const RobotState& robot : world.robots[side]) {
      frame.robots[side].push_back(
          {robot.number, rounded(robot.position_m), rounded_heading(robot.heading)});
    }
  }
  frame.ball = BallObservation{rounded(world.ball.position_m), std::nullopt};
  if (parameters_.reports_height) frame.ball->height_m = as_float_mm(world.ball.height_m);
}

}  // namespace autoref::sim
