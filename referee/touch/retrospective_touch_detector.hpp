// Who touched the ball last, judged in hindsight once the ball has left the field.
//
// docs/touch-detection.md describes two detectors; this is the retrospective touch detector. It
// explains the detections of the last few seconds by hypotheses (touch_hypothesis.hpp): free motion
// of the ball (hull_intersections.hpp), with touches in between. A hypothesis is scored by the
// likelihood of the detections, the prior probability of each touch, and the likelihood of the
// robot that made it (hull_intersections.hpp). The path before a touch must lead to that robot's
// hull; the path after it must start there, or in the robot's dribbler zone along its heading,
// without passing through other robots. A touch that noise hides at first is thus revealed by the
// ball's later path.
//
// The side with the likelier hypothesis touched the ball last. If both are about equally likely, it
// is the side whose robot is nearer to the ball right after the later of the two touches; if
// neither is nearer, the last touch is unknown.
//
// It has no state: every call processes the history from the start of its window.
#pragma once

#include "referee/decision.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/touch_hypothesis.hpp"
#include "soccer/field.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

class RetrospectiveTouchDetector {
 public:
  // Keeps a reference to `frames`. `noise` is the vision noise.
  RetrospectiveTouchDetector(const FrameHistory& frames, const Field& field,
                             const TouchHypothesisParameters& parameters,
                             const tracking::VisionNoise& noise);
  RetrospectiveTouchDetector(const RetrospectiveTouchDetector&) = delete;
  RetrospectiveTouchDetector& operator=(const RetrospectiveTouchDetector&) = delete;

  // The last touch; its side is empty if either side may have made it. `reported` is the online
  // detector's last touch. If nobody touched the ball within the window
  // (TouchHypothesisParameters), or within the stored frames if there is no earlier touch, detect()
  // returns `reported`.
  LastTouch detect(const LastTouch& reported) const;

 private:
  double window_start_s(const LastTouch& reported) const;

  const FrameHistory& frames_;
  Field field_;
  TouchHypothesisParameters parameters_;
};

}  // namespace autoref::referee
