// Tells the hypotheses of what was seen of the ball, and keeps the cheapest.
//
// Whenever the ball comes near a robot, or turns, a new hypothesis tells that it was touched there;
// the others go on without. So a touch is weighed with what the ball did long after it.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>

#include "referee/touch/touch_hypothesis.hpp"

namespace autoref::referee {

class HypothesisTracker {
 public:
  // Keeps a reference to what the basis refers to.
  explicit HypothesisTracker(const HypothesisContext& basis) : basis_(basis) {}

  // Tells what happened from the frame `first`, a detection of the ball, to the newest one. The
  // ball's velocity at `first` is unknown; `before` says who may have touched it last until then.
  // Returns who may have touched it last until now.
  SideMinima track(std::int64_t first, const SideMinima& before);

 private:
  static constexpr std::size_t kMostHypotheses = 10;  // more change no call, fewer do
  // One detection adds a hypothesis of rolling and two of a touch.
  using TouchHypotheses = boost::container::static_vector<TouchHypothesis, kMostHypotheses + 4>;
  using Nlls = boost::container::static_vector<double, TouchHypotheses::static_capacity>;

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
  void strike_twins(Nlls& nlls) const;

  const StoredFrame& now() const { return basis_.frame_history[now_]; }
  double since_former_s() const { return now().time_s - basis_.frame_history[former_].time_s; }

  HypothesisContext basis_;
  std::int64_t now_ = 0;     // the detection told of
  std::int64_t former_ = 0;  // and the one before it
  TouchHypotheses hypotheses_;
};

}  // namespace autoref::referee
