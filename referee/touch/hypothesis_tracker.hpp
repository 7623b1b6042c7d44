// Runs a multiple-hypothesis tracker over the detections of the ball (Reid 1979).
//
// Whenever the ball is near a robot, or an innovation is outside the gate, new hypotheses branch
// off that assume a touch there; the others continue without one. The decision about a touch is
// thus deferred until the ball's later path supports it. The ten likeliest hypotheses are kept.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>

#include "referee/touch/touch_hypothesis.hpp"

namespace autoref::referee {

class HypothesisTracker {
 public:
  // Keeps the context's references, so what they refer to must outlive the tracker.
  explicit HypothesisTracker(const HypothesisContext& basis) : basis_(basis) {}

  // Processes the frames from `first`, a detection of the ball, to the newest one. The ball's
  // velocity at `first` is unknown. `before` contains the per-side minima before `first`. Returns
  // the minima up to the newest frame.
  SideMinima track(std::int64_t first, const SideMinima& before);

 private:
  // Largest number of hypotheses kept. With fewer, some of the referee's calls change; with more,
  // none change.
  static constexpr std::size_t kMostHypotheses = 10;
  // Each detection adds one hypothesis for rolling and two for a touch.
  using TouchHypotheses = boost::container::static_vector<TouchHypothesis, kMostHypotheses + 4>;
  using Deviances = boost::container::static_vector<double, TouchHypotheses::static_capacity>;

  void begin(const SideMinima& minima);
  void go_on();
  void add_rolling();
  const TouchHypothesis* cheapest_sliding() const;
  bool slides_still(const TouchHypothesis& hypothesis) const;
  void add_touch();
  TouchHypothesis hypothesis_of_touch(const BallMotionFilter& motion, const Vec2& onwards_m) const;
  const TouchHypothesis& cheapest() const;
  void follow();
  void follow_jump();
  void follow(TouchHypothesis& hypothesis) const;
  SideMinima best_minima() const;
  void forget_unlikely();
  void strike_twins(Deviances& deviances) const;

  const StoredFrame& now() const { return basis_.frame_history[now_]; }
  double since_former_s() const { return now().time_s - basis_.frame_history[former_].time_s; }

  HypothesisContext basis_;
  std::int64_t now_ = 0;     // the current detection
  std::int64_t former_ = 0;  // the previous one
  TouchHypotheses hypotheses_;
};

}  // namespace autoref::referee
