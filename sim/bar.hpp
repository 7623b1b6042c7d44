// The bar over a goal's mouth, which a flying ball may hit.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::sim {

// A round bar from post to post above the goal's opening (Laws 2014, law 1). The state of a flying
// ball that meets it between two states less than a frame apart: at the place where they meet,
// thrown back along the line between their middles. Nothing where it does not meet the bar.
// `restitution` is the share of the closing speed that is left.
std::optional<BallState> bounced_off_bar(const Field& field, double restitution,
                                         const BallState& former, const BallState& now);

}  // namespace autoref::sim
