// What a flying ball may come down on: the robots' tops and the goals' nets.
#pragma once

#include <optional>
#include <span>

#include "sim/ball.hpp"
#include "sim/box2d_bridge.hpp"
#include "soccer/field.hpp"

namespace autoref::sim {

// Whether the point is over a goal, walls included.
bool is_over_goal(const Field& field, const Vec2& point_m);
// Whether the point is between a goal's walls, or on their line.
bool is_in_goal(const Field& field, const Vec2& point_m);

// Keeps a ball that has just flown from `former_height_m` from passing through a top. A ball that
// comes down on one hops off to the outside, so that none stays up there; one that rises inside a
// goal is stopped by the net. Says the ball's new velocity where it met a top. `robots` counts
// those of the bridge.
std::optional<Vec2> bounced_off_top(const Field& field, const ContactParameters& contacts,
                                    const Box2dBridge& bodies, int robots, double former_height_m,
                                    Ball& ball);

}  // namespace autoref::sim
