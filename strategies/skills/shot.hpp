// Aiming: which part of the goal, or which direction, a kick from the ball's position can use.
#pragma once

#include "soccer/field.hpp"
#include "soccer/tracks.hpp"

namespace autoref::strategies {

struct Aim {
  Vec2 target_m{0, 0};
  double clearance_m = 0;  // from the kick line to the nearest opponent's centre
};

// Distance in metres between the segment from `from_m` to `to_m` and the nearest robot's centre.
double lane_clearance_m(const Vec2& from_m, const Vec2& to_m, const TrackedRobots& robots);

// The point of the opponents' goal with the most clearance from opponents, seen from `ball_m`.
Aim best_shot(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents);

// A point 1 m from the ball, ahead or to a side but not back, with the most clearance on the way.
Aim best_push(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents);

}  // namespace autoref::strategies
