// Which robots may have touched the ball on a short segment of its path, and which are in contact
// with it now.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/referee_configuration.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// A straight segment of the ball's path between two detections. Its ends are given as fractions of
// the time between the detections, from 0 to 1.
struct BallSegment {
  Vec2 from_m{0, 0};
  Vec2 to_m{0, 0};
  double from_share = 0;
  double to_share = 1;
};

// The effect of a touch on the ball: the velocity change to be explained and, once known, the
// velocity after the change.
struct Impulse {
  Vec2 change_mps{0, 0};
  std::optional<Vec2> after_mps;
};

struct Candidate {
  RobotId robot;
  double gap_m = 0;  // gap from the ball's surface to the hull, at the closest approach
  // Time of the closest approach, as a fraction of the time between the detections.
  double share = 0;
  bool explains = false;  // whether a push or kick by the robot explains the velocity change
};
using Candidates = boost::container::static_vector<Candidate, 2 * kMaxRobots>;

// Returns the robots within reach of the segment, with their poses interpolated linearly between
// the two detections. Empty if the ball flies above the robots.
Candidates candidates_on(const BallSegment& segment, const StoredFrame& before,
                         const StoredFrame& after, const Impulse& impulse,
                         const TouchParameters& parameters);

// Minimum distance in metres between the ball's surface and the posts and side walls of the goals
// along the segment.
double gap_to_goals_m(const Field& field, const BallSegment& segment);

// Distance in metres from the ball's surface to the robot's hull; negative if the ball is inside
// the hull.
double gap_to_robot_m(const RobotObservation& robot, const Vec2& ball_m);

// The outward normal of the hull at the ball: the direction of a push.
Vec2 push_direction(const RobotObservation& robot, const Vec2& ball_m);

// The robot with that number; null if it is not in the list.
const RobotObservation* find_robot(const SeenRobots& robots, int number);

// Whether the robot is in contact with the ball. Contact begins when the gap between hull and ball
// is below 1 mm plus one standard deviation of `noise`, and ends with "an observable separation
// between the ball and the robot" (Laws 12; 2026, Dribbling), taken to be 20 mm. `had` says whether
// the robot was in contact with the ball in the previous frame. A ball above the robot is not in
// contact.
bool has_ball(const TrackedRobot& robot, const TrackedBall& ball, bool had,
              const tracking::VisionNoise& noise);

}  // namespace autoref::referee
