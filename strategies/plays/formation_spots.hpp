// Posts: places that a play wants filled, each by the same robot for as long as that makes sense.
#pragma once

#include <boost/container/static_vector.hpp>

#include "strategies/plays/plays.hpp"

namespace autoref::strategies {

struct FormationSpot {
  int key = 1;  // names the post from frame to frame, from 1 on: a zone's number, an opponent's
  Waypoint waypoint;
};
using FormationSpots =
    boost::container::static_vector<FormationSpot, kMaxRobots>;  // the most important first

// Gives each post a robot: the one that had it, else the nearest without one; two change where
// that shortens their ways clearly. Who has another part now gives its post up.
void fill_spots(PlayContext& book, RoleAssignment& assignment, const FormationSpots& spots);

// The same, but the robot at the ball keeps its post, which stays empty meanwhile. Those of the
// first `count` posts go there; the others' robots stay free for something else.
void fill_own_spots(PlayContext& book, RoleAssignment& assignment, const FormationSpots& spots,
                    int count = kMaxRobots);

// Those `count` of the free robots that are farthest ahead run for passes.
void send_ahead(PlayContext& book, RoleAssignment& assignment, int count);

// `position_m`, far enough from the opponents' area for every rule, and `more_m` farther; facing
// the ball.
Waypoint off_their_area(const PredictedState& predicted, const Vec2& position_m, double more_m = 0);

}  // namespace autoref::strategies
