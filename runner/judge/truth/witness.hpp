// Sees a whole game as it truly is, and tells what happened in it by the rules.
//
// It follows the referee's commands, since they decide what is play and who takes a restart, but
// none of its calls: the field and the ball are the world's own.
#pragma once

#include <memory>
#include <vector>

#include "runner/judge/truth/scene.hpp"

namespace autoref::runner::truth {

class Witness {
 public:
  Witness(const Field& field, const RuleBook& rules, double frame_rate_hz);

  // Number 0 until named otherwise.
  void name_keeper(Side side, int number) { keepers_[side] = number; }

  // To be called once per frame, after the referee: `signal` is what it has just said.
  void see(const sim::World& world, const RefereeSignal& signal);
  // The same with touches and meetings apart, for staged games.
  void see(const sim::WorldState& now, std::span<const sim::Touch> touches,
           std::span<const sim::Meeting> meetings, const RefereeSignal& signal);

  // All so far, in the order of frames.
  const Happenings& happenings() const { return happenings_; }
  const Play& play() const { return play_.play(); }
  const BallStory& ball() const { return ball_; }

 private:
  void tell(const Scene& scene);
  void note_fouls(std::size_t from);

  Field field_;
  RuleBook rules_;
  double frame_s_;
  PlayFollower play_;
  BallStory ball_;
  std::vector<std::unique_ptr<Truth>> truths_;
  sim::WorldState before_;
  RefereeSignal signal_;  // in force since the frame before
  bool has_begun_ = false;
  PerSide<int> keepers_;
  PerSide<double> fouled_s_;
  Happenings happenings_;
};

}  // namespace autoref::runner::truth
