// Estimates how open the goal is for a shot, and how safe a pass is.
#pragma once

#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/tracks.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies {

// Where to aim: the part of the goal, or the direction, that a kick from the ball's position can
// use.
struct Aim {
  Vec2 target_m{0, 0};
  double clearance_m = 0;  // from the kick line to the nearest opponent's centre
};

// Distance in metres between the segment from `from_m` to `to_m` and the nearest robot's centre.
double lane_clearance_m(const Vec2& from_m, const Vec2& to_m, const TrackedRobots& robots);

// The point of the opponents' goal to which a kick from `ball_m` has the most clearance from
// opponents.
Aim best_shot(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents);

// A point 1 m from the ball, ahead or to a side but not behind, to which a kick has the most
// clearance from opponents.
Aim best_push(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents);

// The segment along which a ball is kicked, for queries about many robots.
class Lane {
 public:
  Lane(const Vec2& from_m, const Vec2& to_m)
      : from_m_(from_m), to_m_(to_m), offset_(to_m - from_m), length2_(offset_.squaredNorm()) {}

  // Whether the squared distance of the point from the line through both ends exceeds `distance2`
  // by far more than rounding errors. This is a cheap test that implies that the point is also
  // farther than that from the lane.
  bool is_beyond(const Vec2& point_m, double distance2) const {
    return square(cross(offset_, point_m - from_m_)) >
           (distance2 * (1 + kMargin) + kMargin_m2) * length2_;
  }

  Vec2 nearest_m(const Vec2& point_m) const { return nearest_on_segment(point_m, from_m_, to_m_); }

 private:
  static constexpr double kMargin = 1e-7;
  static constexpr double kMargin_m2 = 1e-12;

  Vec2 from_m_;
  Vec2 to_m_;
  Vec2 offset_;
  double length2_;
};

// The widest free part of the opponents' goal, as seen from a point.
struct Opening {
  Vec2 target_m{0, 0};  // the centre of that part
  double half_width_m = 0;
  double chance = 0;  // probability that a shot at it scores
};

// The kick of a shot, and the robot that does not count as a blocker.
struct ShotTerms {
  double kick_mps = kUsualAbilities.kick_mps;
  int but_mate = -1;  // number of the team's robot that shoots, which does not block the shot
  double kick_error_rad = KickScatter{}.direction_rad;
};

// Finds the widest opening. Opponents cover the positions that they can reach while the ball is
// moving; the team's own robots cover only their hulls.
Opening widest_opening(const Field& field, const Vec2& from_m, const TrackedRobots& opponents,
                       const TrackedRobots& own, const ShotTerms& terms);

// A kick at this fraction of the ball's speed limit, with a speed that scatters by `speed_error`,
// stays below the limit in 98 of 100 cases (two standard deviations).
constexpr double share_below_limit(double speed_error) { return 1 / (1 + 2 * speed_error); }

// How safe a pass along the ground from one point to the other is, from 0 to 1, given the opponents
// in the ball's path and those that can reach the path in time.
double pass_safety(const Vec2& from_m, const Vec2& to_m, double kick_mps,
                   const TrackedRobots& opponents);

}  // namespace autoref::strategies
