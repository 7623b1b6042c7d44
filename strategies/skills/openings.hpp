// Estimates how open the goal is for a shot, and how safe a pass is.
#pragma once

#include "soccer/abilities.hpp"
#include "soccer/field.hpp"
#include "soccer/tracks.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies {

// The widest free part of the opponents' goal, seen from a point.
struct Opening {
  Vec2 target_m{0, 0};  // the centre of that part
  double half_width_m = 0;
  double chance = 0;  // probability that a shot at it scores
};

// The kick, and the robot that does not count as a blocker.
struct ShotTerms {
  double kick_mps = kUsualAbilities.kick_mps;
  int but_mate = -1;  // number of the team's robot that shoots
  double kick_error_rad = KickScatter{}.direction_rad;
};

// Finds the widest opening. Opponents cover what they can reach while the ball is moving; the
// team's own robots cover only their hulls.
Opening widest_opening(const Field& field, const Vec2& from_m, const TrackedRobots& opponents,
                       const TrackedRobots& own, const ShotTerms& terms);

// The fraction of a limit on the ball's speed at which a kick whose speed scatters by this fraction
// stays below it in 98 of 100 cases (two standard deviations).
constexpr double share_below_limit(double speed_error) { return 1 / (1 + 2 * speed_error); }

// How safely a ball kicked along the ground gets from one point to the other, 0 to 1, given the
// opponents in its path and those that can reach it in time.
double pass_safety(const Vec2& from_m, const Vec2& to_m, double kick_mps,
                   const TrackedRobots& opponents);

}  // namespace autoref::strategies
