// Formation spots: positions that a play wants to fill, each filled by the same robot for as long
// as possible.
#pragma once

#include <boost/container/static_vector.hpp>

#include "strategies/plays/plays.hpp"

namespace autoref::strategies {

struct FormationSpot {
  int key = 1;  // identifies the spot across frames, from 1: the number of a zone or of an opponent
  Waypoint waypoint;
};
using FormationSpots =
    boost::container::static_vector<FormationSpot, kMaxRobots>;  // most important first

// Assigns a robot to each spot: its previous owner, or else the nearest free robot. Two robots swap
// spots if that clearly shortens their paths. A robot that already has another role loses its spot.
void fill_spots(PlayContext& book, RoleAssignment& assignment, const FormationSpots& spots);

// Assigns robots in the same way, but the robot at the ball keeps its claim to its spot, which
// stays empty in the meantime. Only the owners of the first `count` spots go to them; the other
// owners stay free for other roles.
void fill_own_spots(PlayContext& book, RoleAssignment& assignment, const FormationSpots& spots,
                    int count = kMaxRobots);

// Makes the `count` free robots that are farthest ahead run for passes.
void send_ahead(PlayContext& book, RoleAssignment& assignment, int count);

// `position_m`, moved away from the opponents' defence area by the distance that satisfies all
// rules, plus `more_m`, and facing the ball.
Waypoint off_their_area(const PredictedState& predicted, const Vec2& position_m, double more_m = 0);

}  // namespace autoref::strategies
