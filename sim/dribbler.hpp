// The dribbler: a roller that pulls the ball to the front plate.
#pragma once

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

// The force in newtons, in field coordinates, of a running dribbler on a ball in its dribbler zone
// during the next `duration_s`; zero if the ball is out of reach. Its magnitude is at most force_n.
//
// An ordinary dribbler pulls the ball towards the plate's centre and damps its motion relative to
// the plate, so hard turns and sideways jerks lose it. A holding one cancels all relative motion at
// once and centres the ball at centring_mps at most, so the ball never gets faster than the plate
// by more than that.
Vec2 dribbler_force_n(const DribblerParameters& parameters, const BodyState& robot,
                      const BodyState& ball, double ball_mass_kg, double ball_height_m,
                      double duration_s);

}  // namespace autoref::sim
