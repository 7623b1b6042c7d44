#include "referee/touch/retrospective_touch_detector.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/hypothesis_tracker.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "referee/touch/touch_hypothesis.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// Distances that differ by less than this are equal: rounding differs between the two ends of the
// field.
constexpr double kNearer_m = 0.05e-3;

// The result if either side may have made the last touch.
LastTouch unknown_touch(const LastTouch& west, const LastTouch& east) {
  LastTouch touch;
  touch.time_s = std::max(west.time_s, east.time_s);
  touch.gap_m = std::min(west.gap_m, east.gap_m);
  touch.speed_change_mps = std::max(west.speed_change_mps, east.speed_change_mps);
  return touch;
}

// Distance from the ball's centre to the hull of the robot that made the touch, at the first
// detection not before `since_s`; kNever if there is no such detection, or if the robot is unknown.
double distance_after_m(const FrameHistory& frames, const LastTouch& touch, double since_s) {
  const std::int64_t number = frames.first_detection(since_s);
  if (!touch.robot || number > frames.newest()) return kNever;
  const StoredFrame& frame = frames[number];
  const RobotObservation* robot = find_robot(frame.robots[touch.robot->side], touch.robot->number);
  if (robot == nullptr) return kNever;
  return distance_to_hull(frame.ball.position_m, robot->position_m, robot->heading);
}

// The touch of the robot that is nearer to the ball once both may have touched it: a ball squeezed
// between two robots leaves the farther one first. Null if neither is nearer.
const LastTouch* nearer_touch(const FrameHistory& frames, const LastTouch& west,
                              const LastTouch& east) {
  const double since_s = std::max(west.time_s, east.time_s);
  const double west_m = distance_after_m(frames, west, since_s);
  const double east_m = distance_after_m(frames, east, since_s);
  if (std::abs(west_m - east_m) < kNearer_m) return nullptr;
  return west_m < east_m ? &west : &east;
}

}  // namespace

RetrospectiveTouchDetector::RetrospectiveTouchDetector(const FrameHistory& frames,
                                                       const Field& field,
                                                       const TouchHypothesisParameters& parameters,
                                                       const tracking::VisionNoise& noise)
    : frames_(frames), field_(field), parameters_(parameters) {
  parameters_.motion.detection_m = std::max(noise.ball_m, parameters.motion.detection_m);
  parameters_.intersection.robot_m = noise.robot_m;
  parameters_.intersection.robot_rad = noise.robot_rad;
  parameters_.near_m += 3 * noise.ball_m;
}

double RetrospectiveTouchDetector::window_start_s(const LastTouch& reported) const {
  const double now_s = frames_[frames_.newest()].time_s;
  return std::min(now_s - parameters_.window_s, reported.time_s - parameters_.before_reported_s);
}

LastTouch RetrospectiveTouchDetector::detect(const LastTouch& reported) const {
  const std::int64_t first = frames_.first_detection(window_start_s(reported));
  if (first > frames_.newest()) return reported;
  const bool is_reported_before = reported.side && reported.time_s < frames_[first].time_s;
  SideMinima before;
  before.offer(is_reported_before ? toucher_of(*reported.side) : kNobody, 0, reported);
  const SideMinima best = HypothesisTracker({field_, parameters_, frames_}).track(first, before);
  if (best.deviance[kNobody] <= std::min(best.deviance[kWest], best.deviance[kEast]))
    return reported;
  const LastTouch& west = best.touch[kWest];
  const LastTouch& east = best.touch[kEast];
  const double lead = best.deviance[kEast] - best.deviance[kWest];
  const LastTouch* likelier = lead > 0 ? &west : &east;
  if (std::abs(lead) < parameters_.lead_deviance) likelier = nearer_touch(frames_, west, east);
  if (likelier == nullptr) return unknown_touch(west, east);
  LastTouch last = *likelier;
  const LastTouch& other = likelier == &west ? east : west;
  if (other.robot) last.runner_up = other.robot;
  return last;
}

}  // namespace autoref::referee
