// Measures the speed at which two opponents collided, from vision frames before and after.
//
// A robot's motion before the collision is a weighted least-squares fit with constant acceleration
// to its detections of the last 0.2 s. Since robots may start to brake at any time, an unknown jerk
// of 30 m/s3 makes old detections less certain, and the acceleration has a Gaussian prior of 2 m/s2
// against the motion, with a standard deviation of 2 m/s2. The robots collide at the time when
// their 180 mm cylinders touch according to the fits, provided that later frames agree. They do not
// agree if a ball or a third robot keeps the cylinders apart.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>
#include <span>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// Two robots in one frame; nullopt for a robot that vision did not see.
struct PairSample {
  double time_s = 0;
  PerSide<std::optional<Vec2>> position_m;
};

using PairPath = boost::container::static_vector<PairSample, 64>;

// The motion of both robots at the moment of contact.
struct MeasuredCollision {
  double time_s = 0;
  PerSide<Vec2> position_m{{Vec2(0, 0), Vec2(0, 0)}};
  PerSide<Vec2> velocity_mps{{Vec2(0, 0), Vec2(0, 0)}};  // just before contact
  double closing_mps = 0;            // relative velocity along the line of their centres
  double closing_deviation_mps = 0;  // standard deviation of `closing_mps`
};

// The collision of two robots at or after `from_s`. `path` holds frames in order of time, from
// about 0.2 s before the collision to three frames after it. Returns nullopt if the robots do not
// collide or if vision saw them in too few frames.
std::optional<MeasuredCollision> measure_collision(std::span<const PairSample> path, double from_s,
                                                   const tracking::VisionNoise& noise);

}  // namespace autoref::referee
