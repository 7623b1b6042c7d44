// The bar over a goal's mouth, which a flying ball may hit.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::sim {

// A round steel bar of at most 10 mm from post to post, its bottom 155 mm above the carpet (Laws
// 2014, law 1). The state of a flying ball that meets it between two states less than a frame
// apart: at the place where they meet, thrown back along the line between their middles. Nothing
// where it does not meet the bar.
std::optional<BallState> bounced_off_bar(const Field& field, const BallState& former,
                                         const BallState& now);

}  // namespace autoref::sim
