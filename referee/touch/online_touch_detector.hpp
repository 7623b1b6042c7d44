// Estimates during play who touched the ball last: the paper's input c (table 1), from vision
// alone.
//
// Deviation D16: the paper's AutoRef takes c as given.
//
// docs/touch-detection.md describes two detectors; this is the online touch detector. It judges
// each frame from the most recent detections of the ball. A touch is visible in the ball's motion:
// either its velocity or position changes by more than carpet and noise can explain while a robot's
// hull is at the ball, or the ball stays at a moving hull and moves along with it. Being near the
// ball is not enough for a touch. A velocity change with no robot nearby is not a touch either, but
// comes from a post or a wall. If robots of both sides explain a velocity change about equally
// well, the last touch is unknown.
//
// The referee restarts the detector when play starts and updates it after each frame of play.
#pragma once

#include <cstdint>
#include <optional>

#include "referee/decision.hpp"
#include "referee/referee_configuration.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/kept_touch.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "referee/touch/velocity_change_detector.hpp"
#include "soccer/field.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

class OnlineTouchDetector {
 public:
  // Keeps a reference to `frames`. `noise` is the vision noise.
  OnlineTouchDetector(const FrameHistory& frames, const Field& field,
                      const TouchParameters& parameters, const tracking::VisionNoise& noise = {})
      : frames_(frames),
        field_(field),
        parameters_(with_noise(parameters, noise)),
        robot_noise_m_(noise.robot_m),
        velocity_changes_(frames, parameters_) {}
  OnlineTouchDetector(const OnlineTouchDetector&) = delete;
  OnlineTouchDetector& operator=(const OnlineTouchDetector&) = delete;

  // Forgets all touches. Call after FrameHistory::restart().
  void restart();

  // What is known before a gap in vision. Call before FrameHistory::restart(); nullopt if the ball
  // has not been seen in this play.
  std::optional<BeforeGap> before_gap() const;

  // Continues after a gap in vision. Call after restart().
  void resume(const BeforeGap& before) { gap_ = before; }

  // Judges the newest frame of the history, if it has a ball.
  void update();

  const LastTouch& last() const { return last_; }

 private:
  static TouchParameters with_noise(TouchParameters parameters, const tracking::VisionNoise& noise);
  void forget_detections();
  void resume_after_gap();
  void look_back_over_gap();
  void detect_sudden_change();
  void detect_contacts();
  void detect_velocity_change();
  bool carries_ball(RobotId id) const;
  bool pushed_softly(const RobotObservation& robot) const;
  double touching_m() const;
  double noise_m() const;
  bool is_sudden_change() const;
  bool is_landing() const;
  std::optional<double> share_of_single_touch() const;
  void detect_single_touch(double share);
  void detect_onwards();
  Verdict verdict_on(const BallSegment& segment, int interval, const Impulse& impulse) const;
  void conclude(const Verdict& verdict, int interval, const Vec2& change_mps);
  void apply(const Verdict& verdict, double time_s, double speed_change_mps);

  const BallDetection& ball(int back) const { return frames_.detection(back).ball; }
  Vec2 change_mps(int from_back, int to_back) const {
    return ball(to_back).velocity_mps - ball(from_back).velocity_mps;
  }

  static constexpr int kUsed = 4;  // number of detections used to judge a frame

  const FrameHistory& frames_;
  Field field_;
  TouchParameters parameters_;
  double robot_noise_m_ = 0;
  std::int64_t judged_ = 0;  // number of detections in the history
  int known_ = 0;            // detections since play started or the ball was lost, up to kUsed
  bool is_open_ = false;     // the next frame may revise the newest velocity change
  LastTouch settled_;        // the last touch before the newest velocity change
  VelocityChangeDetector velocity_changes_;
  double changed_s_ = 0;          // time of the last velocity change seen from frame to frame
  std::optional<BeforeGap> gap_;  // what was known before the newest gap; set until the ball has
                                  // been seen often enough since
  LastTouch last_;
};

}  // namespace autoref::referee
