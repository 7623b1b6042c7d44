#include "referee/touch/retrospective_touch_detector.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/hypothesis_tracker.hpp"
#include "referee/touch/touch_hypothesis.hpp"

namespace autoref::referee {
namespace {

// The result if either side may have made the last touch.
LastTouch unknown_touch(const LastTouch& west, const LastTouch& east) {
  LastTouch touch;
  touch.time_s = std::max(west.time_s, east.time_s);
  touch.gap_m = std::min(west.gap_m, east.gap_m);
  touch.speed_change_mps = std::max(west.speed_change_mps, east.speed_change_mps);
  return touch;
}

}  // namespace

RetrospectiveTouchDetector::RetrospectiveTouchDetector(const FrameHistory& frames,
                                                       const Field& field,
                                                       const TouchHypothesisParameters& parameters,
                                                       const VisionNoise& noise)
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
  const double lead = best.deviance[kEast] - best.deviance[kWest];
  if (std::abs(lead) < parameters_.lead_deviance) {
    return unknown_touch(best.touch[kWest], best.touch[kEast]);
  }
  LastTouch last = best.touch[lead > 0 ? kWest : kEast];
  const LastTouch& other = best.touch[lead > 0 ? kEast : kWest];
  if (other.robot) last.runner_up = other.robot;
  return last;
}

}  // namespace autoref::referee
