// What a flying ball may land on: robot tops and goal nets.
#pragma once

#include <optional>
#include <span>

#include "sim/ball.hpp"
#include "sim/box2d_bridge.hpp"
#include "soccer/field.hpp"

namespace autoref::sim {

// Whether the point is above a goal, including its walls.
bool is_over_goal(const Field& field, const Vec2& point_m);
// Whether the point is between a goal's walls, or on its line.
bool is_in_goal(const Field& field, const Vec2& point_m);

// Keeps a ball that has just flown from `former_height_m` from passing through a top. A ball that
// lands on one bounces outwards, so that none stays up there; a ball rising inside a goal is
// stopped by the net. Returns the ball's new velocity if it hit a top. `robots` is the bridge's
// number of robots.
std::optional<Vec2> bounced_off_top(const Field& field, const ContactParameters& contacts,
                                    const Box2dBridge& bodies, int robots, double former_height_m,
                                    Ball& ball);

}  // namespace autoref::sim
