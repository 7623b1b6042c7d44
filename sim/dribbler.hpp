// The dribbler: a roller that pulls the ball to the front plate.
#pragma once

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

// The force in newtons, in the field's frame, with which a running dribbler pulls a ball in its
// mouth to the plate's middle and slows it relative to the plate; zero for a ball out of reach. It
// is never more than force_n, so that hard turns and sideways jerks lose the ball.
Vec2 dribbler_force_n(const DribblerParameters& parameters, const BodyState& robot,
                      const BodyState& ball, double ball_height_m);

}  // namespace autoref::sim
