// How open a goal is, and how safe a pass: what a kick can be expected to come to.
#pragma once

#include "soccer/field.hpp"
#include "soccer/tracks.hpp"

namespace autoref::strategies {

// The widest free part of the opponents' goal mouth, seen from a point.
struct Opening {
  Vec2 target_m{0, 0};  // its middle
  double half_width_m = 0;
  double chance = 0;  // that a shot at it scores, 0 to 1
};

// What the shot is taken with, and who is left out of the blockers.
struct ShotTerms {
  double kick_mps = 8.0;
  int but_mate = -1;  // number of the own robot that shoots
};

// Opponents cover what they can step into while the ball comes, own robots what they stand in.
Opening widest_opening(const Field& field, const Vec2& from_m, const TrackedRobots& opponents,
                       const TrackedRobots& own, const ShotTerms& terms);

// How safely a ball kicked along the ground gets from one point to the other, 0 to 1: whether an
// opponent is on its way or can get there in time.
double pass_safety(const Vec2& from_m, const Vec2& to_m, double kick_mps,
                   const TrackedRobots& opponents);

}  // namespace autoref::strategies
