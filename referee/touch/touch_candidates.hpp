// Which robots may have touched the ball on a short way of it.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/touch/frame_history.hpp"
#include "referee/touch_parameters.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// A straight way of the ball during a part of the time between two detections; the shares of that
// time run from 0 to 1.
struct BallSegment {
  Vec2 from_m{0, 0};
  Vec2 to_m{0, 0};
  double from_share = 0;
  double to_share = 1;
};

// What a touch did to the ball: the change of velocity that it must explain, and, once known, the
// velocity that it led to.
struct Impulse {
  Vec2 change_mps{0, 0};
  std::optional<Vec2> after_mps;
};

struct Candidate {
  RobotId robot;
  double gap_m = 0;       // from the ball's surface to the hull, at the nearest
  double share = 0;       // when that was
  bool explains = false;  // whether a push or kick by it changes the velocity in this way
};
using Candidates = boost::container::static_vector<Candidate, 2 * kMaxRobots>;

// The robots within reach of the ball on its way between two detections. Robots move evenly between
// them. Balls that fly over a robot are out of its reach.
Candidates candidates_on(const BallSegment& segment, const StoredFrame& before,
                         const StoredFrame& after, const Impulse& impulse,
                         const TouchParameters& parameters);

// Distance in metres from the ball's surface to the nearest goal post or side wall of a goal,
// the least on its way.
double gap_to_goals_m(const Field& field, const BallSegment& segment);

// Distance in metres from the ball's surface to the robot's hull; negative inside.
double gap_to_robot_m(const RobotObservation& robot, const Vec2& ball_m);

// The direction in which the ball gets away from the hull fastest: that of a push.
Vec2 push_direction(const RobotObservation& robot, const Vec2& ball_m);

// The same robot in another frame; null where it is not in it.
const RobotObservation* find_robot(const SeenRobots& robots, int number);

}  // namespace autoref::referee
