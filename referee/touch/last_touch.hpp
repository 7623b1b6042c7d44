// Who touched the ball last: the paper's input c (table 1), told from vision alone.
//
// Deviation D16: the paper's AutoRef takes c as given.
//
// A touch shows in the ball's motion: its velocity kinks or jumps by more than the carpet explains
// while a robot's hull is at it, or it stays at a moving hull and moves along. A robot that is
// merely near did not touch the ball, and a kink with no robot near (a post, a wall) is no touch.
// Where robots of both sides explain a kink about equally well, the last touch is unknown.
//
// It owns the last few sightings. The referee restarts it when play starts and feeds it each frame
// of play; while the ball is placed it sees nothing.
#pragma once

#include <array>
#include <optional>

#include "referee/decision.hpp"
#include "referee/touch/gentle_kinks.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "referee/touch_parameters.hpp"
#include "referee/touch/verdict.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

class LastTouchDetector {
 public:
  LastTouchDetector(const Field& field, const TouchParameters& parameters,
                    const VisionNoise& noise = {})
      : field_(field), parameters_(with_noise(parameters, noise)), gentle_(parameters_) {}

  // Play starts: nobody has touched the ball, which lies still at `ball_m`, if it was ever seen.
  void restart(const Frame& frame, const std::optional<Vec2>& ball_m);

  // The ball's sightings before tell nothing of those to come; the last touch stays.
  void lose_sight();

  // Judges one frame of play. Frames without a ball, or not later than the one before, are skipped.
  void update(const Frame& frame);

  const LastTouch& last() const { return last_; }

 private:
  static TouchParameters with_noise(TouchParameters parameters, const VisionNoise& noise);
  void push(const Frame& frame);
  void judge_after_gap();
  void judge_kink();
  void judge_contacts();
  void judge_gentle_kink();
  bool carries_ball(RobotId id) const;
  bool pushed_softly(const RobotObservation& robot) const;
  double touching_m() const;
  bool is_kink() const;
  bool is_landing() const;
  std::optional<double> share_of_single_touch() const;
  void judge_single(double share);
  void judge_onwards();
  Verdict verdict_on(const BallWay& way, int interval, const Impulse& impulse) const;
  void conclude(const Verdict& verdict, int interval, const Vec2& change_mps);
  void take(const Verdict& verdict, double time_s, double speed_change_mps);

  // The i-th sighting back from the newest.
  const Sighting& sighting(int back) const {
    return sightings_[static_cast<std::size_t>((newest_ + kKept - back) % kKept)];
  }
  Vec2 change_mps(int from_back, int to_back) const {
    return sighting(to_back).velocity_mps - sighting(from_back).velocity_mps;
  }

  static constexpr int kKept = 4;

  Field field_;
  TouchParameters parameters_;
  std::array<Sighting, kKept> sightings_;
  int newest_ = 0;
  int known_ = 0;         // sightings, up to kKept
  bool is_open_ = false;  // whether the newest kink waits for what the next frame says of it
  LastTouch settled_;     // before that kink
  GentleKinks gentle_;
  double kinked_s_ = 0;  // time of the last kink told from frame to frame
  LastTouch last_;
};

}  // namespace autoref::referee
