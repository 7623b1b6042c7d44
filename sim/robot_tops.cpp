#include "sim/robot_tops.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

// Whether the point is over a goal's side wall where it goes on to the field's wall.
bool is_over_goal_side(const Field& field, const Vec2& point_m) {
  const double beside_m = std::abs(point_m.y()) - field.half_goal_m();
  return field.goal_sides_reach_wall && std::abs(point_m.x()) > field.half_length_m() &&
         beside_m >= 0.0 && beside_m <= field.goal_wall_thickness_m;
}

double bounced_vertical(const ContactParameters& contacts, const Ball& ball) {
  return std::max(contacts.top_leaving_mps, -contacts.top_restitution * ball.vertical_mps());
}

// `velocity_mps`, with its component along `outwards` relative to the top raised to at least
// `least_mps`.
Vec2 leaving(const Vec2& velocity_mps, const Vec2& top_mps, const Vec2& outwards,
             double least_mps) {
  const double now = (velocity_mps - top_mps).dot(outwards);
  return velocity_mps + std::max(0.0, least_mps - now) * outwards;
}

}  // namespace

bool is_over_goal(const Field& field, const Vec2& point_m) {
  const double x = std::abs(point_m.x()) - field.half_length_m();
  return x >= 0.0 && x <= field.goal_depth_m + field.goal_wall_thickness_m &&
         std::abs(point_m.y()) <= field.half_goal_m() + field.goal_wall_thickness_m;
}

bool is_in_goal(const Field& field, const Vec2& point_m) {
  const double x = std::abs(point_m.x()) - field.half_length_m();
  return x >= 0.0 && x <= field.goal_depth_m && std::abs(point_m.y()) <= field.half_goal_m();
}

std::optional<Vec2> bounced_off_top(const Field& field, const ContactParameters& contacts,
                                    const Box2dBridge& bodies, int robots, double former_height_m,
                                    Ball& ball) {
  // The ball hits a top if its height crosses the top's within the step. A step is short, so its
  // end approximates the position of the crossing.
  const double height_m = ball.height_m();
  const BodyState& body = bodies.ball();
  const double net_m = field.goal_opening_height_m;
  if (former_height_m < net_m && height_m >= net_m && is_in_goal(field, body.position_m)) {
    ball.bounce_in_air(former_height_m, 0.0);
    return body.velocity_mps;
  }
  if (former_height_m >= net_m && height_m < net_m && is_over_goal(field, body.position_m)) {
    ball.bounce_in_air(net_m, bounced_vertical(contacts, ball));
    return leaving(body.velocity_mps, {0.0, 0.0}, {std::copysign(1.0, body.position_m.x()), 0.0},
                   contacts.top_leaving_mps);
  }
  if (former_height_m >= net_m && height_m < net_m && is_over_goal_side(field, body.position_m)) {
    ball.bounce_in_air(net_m, bounced_vertical(contacts, ball));
    return leaving(body.velocity_mps, {0.0, 0.0}, {0.0, std::copysign(1.0, body.position_m.y())},
                   contacts.top_leaving_mps);
  }
  if (former_height_m < kRobotHeight_m || height_m >= kRobotHeight_m) return std::nullopt;
  for (int i = 0; i < robots; ++i) {
    if (!bodies.is_on(i)) continue;
    const BodyState& robot = bodies.robot(i);
    if (distance_to_hull(body.position_m, robot.position_m, robot.heading) >= 0.0) continue;
    ball.bounce_in_air(kRobotHeight_m, bounced_vertical(contacts, ball));
    return leaving(body.velocity_mps, robot.velocity_mps,
                   direction_of(body.position_m - robot.position_m, robot.heading),
                   contacts.top_leaving_mps);
  }
  return std::nullopt;
}

}  // namespace autoref::sim
