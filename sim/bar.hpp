// The crossbar of a goal, which a flying ball may hit.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::sim {

// Collides a flying ball with the bar, which is round and runs from post to post above the goal's
// opening (Laws 2014, law 1). The two given states are less than a frame apart. Returns the ball's
// state at the point of contact, reflected along the line between the centres; nullopt if it misses
// the bar. `restitution`: ratio of separation to closing speed.
std::optional<BallState> bounced_off_bar(const Field& field, double restitution,
                                         const BallState& former, const BallState& now);

}  // namespace autoref::sim
