// Who touched the ball last, judged in hindsight.
//
// What was seen of the ball in the last seconds is explained by hypotheses (touch_hypothesis.hpp):
// chains of free ways (ball_motion_filter.hpp), joined by touches. Each costs minus twice the
// logarithm of its likelihood: of the detections along each way, of each touch at all, and of its
// robot (hull_intersections.hpp): the way before must lead to that robot's hull, and the way after
// must come from there, or out of its mouth along its heading, without going through anybody. So
// one that noise hid at first shows by where the ball went later.
//
// The side whose cheapest hypothesis costs less touched the ball last; where both cost about the
// same, nobody knows.
//
// It owns the last frames; the hypotheses are told when asked for. The referee restarts it when
// play starts, feeds it each frame of play, and asks it when the ball has left the field.
#pragma once

#include "referee/decision.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/touch_hypothesis_parameters.hpp"
#include "soccer/field.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

class RetrospectiveTouchDetector {
 public:
  // Keeps a reference to the history. `noise` is vision's.
  RetrospectiveTouchDetector(const FrameHistory& frames, const Field& field,
                             const TouchHypothesisParameters& parameters, const VisionNoise& noise);
  RetrospectiveTouchDetector(const RetrospectiveTouchDetector&) = delete;
  RetrospectiveTouchDetector& operator=(const RetrospectiveTouchDetector&) = delete;

  // The last touch; of nobody's side where either side's may have been. `reported` is what was told
  // while play was on (last_touch.hpp): it is the answer where nobody touched the ball during the
  // seconds that are looked at, `TouchHypothesisParameters::window_s`.
  LastTouch detect(const LastTouch& reported) const;

 private:
  double window_start_s(const LastTouch& reported) const;

  const FrameHistory& frames_;
  Field field_;
  TouchHypothesisParameters parameters_;
};

}  // namespace autoref::referee
