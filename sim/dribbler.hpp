// The dribbler: a roller that pulls the ball to the front plate.
#pragma once

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

// The force in newtons, in the field's frame, with which a running dribbler acts during the next
// `duration_s` on a ball in its mouth; zero for a ball out of reach. It is never more than force_n.
//
// A roller pulls the ball to the plate's middle and slows it relative to the plate, so that hard
// turns and sideways jerks lose it. One that holds takes all of the ball's motion relative to the
// plate at once, and brings it to the middle at centring_mps at most: the ball never gets faster
// than the plate by more than that.
Vec2 dribbler_force_n(const DribblerParameters& parameters, const BodyState& robot,
                      const BodyState& ball, double ball_mass_kg, double ball_height_m,
                      double duration_s);

}  // namespace autoref::sim
