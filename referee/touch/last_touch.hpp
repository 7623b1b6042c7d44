// Who touched the ball last: the paper's input c (table 1), told from vision alone.
//
// Deviation D16: the paper's AutoRef takes c as given.
//
// A touch shows in the ball's motion: its velocity changes or jumps by more than the carpet
// explains while a robot's hull is at it, or it stays at a moving hull and moves along. A robot
// that is merely near did not touch the ball, and a velocity change with no robot near (a post, a
// wall) is no touch. Where robots of both sides explain a velocity change about equally well, the
// last touch is unknown.
//
// It owns the last few detections. The referee restarts it when play starts and feeds it each frame
// of play; while the ball is placed it sees nothing.
#pragma once

#include <array>
#include <optional>

#include "referee/decision.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "referee/touch/velocity_change_detector.hpp"
#include "referee/touch/verdict.hpp"
#include "referee/touch_parameters.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

class LastTouchDetector {
 public:
  LastTouchDetector(const Field& field, const TouchParameters& parameters,
                    const VisionNoise& noise = {})
      : field_(field), parameters_(with_noise(parameters, noise)), velocity_changes_(parameters_) {}

  // Play starts: nobody has touched the ball, which lies still at `ball_m`, if it was ever seen.
  void restart(const Frame& frame, const std::optional<Vec2>& ball_m);

  // The ball's detections before tell nothing of those to come; the last touch stays.
  void lose_sight();

  // Judges one frame of play. Frames without a ball, or not later than the one before, are skipped.
  void update(const Frame& frame);

  const LastTouch& last() const { return last_; }

 private:
  static TouchParameters with_noise(TouchParameters parameters, const VisionNoise& noise);
  void push(const Frame& frame);
  void resume_after_gap();
  void detect_sudden_change();
  void detect_contacts();
  void detect_velocity_change();
  bool carries_ball(RobotId id) const;
  bool pushed_softly(const RobotObservation& robot) const;
  double touching_m() const;
  bool is_sudden_change() const;
  bool is_landing() const;
  std::optional<double> share_of_single_touch() const;
  void detect_single_touch(double share);
  void detect_onwards();
  Verdict verdict_on(const BallSegment& segment, int interval, const Impulse& impulse) const;
  void conclude(const Verdict& verdict, int interval, const Vec2& change_mps);
  void take(const Verdict& verdict, double time_s, double speed_change_mps);

  // The i-th detection back from the newest.
  const Detection& detection(int back) const {
    return detections_[static_cast<std::size_t>((newest_ + kKept - back) % kKept)];
  }
  Vec2 change_mps(int from_back, int to_back) const {
    return detection(to_back).velocity_mps - detection(from_back).velocity_mps;
  }

  static constexpr int kKept = 4;

  Field field_;
  TouchParameters parameters_;
  std::array<Detection, kKept> detections_;
  int newest_ = 0;
  int known_ = 0;  // detections, up to kKept
  bool is_open_ =
      false;  // whether the newest velocity change waits for what the next frame says of it
  LastTouch settled_;  // before that velocity change
  VelocityChangeDetector velocity_changes_;
  double changed_s_ = 0;  // time of the last velocity change told from frame to frame
  LastTouch last_;
};

}  // namespace autoref::referee
