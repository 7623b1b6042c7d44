// Sees a whole game as it truly is, and tells what happened in it by the rules.
//
// It follows the referee's commands, since they decide what is play and who takes a restart, but
// none of its calls: the field and the ball are the world's own.
#pragma once

#include <memory>
#include <vector>

#include "runner/judge/truth/scene.hpp"

namespace autoref::runner::ground_truth {

class GroundTruthObserver {
 public:
  GroundTruthObserver(const Field& field, const RuleBook& rules, double frame_rate_hz);

  // Number 0 until named otherwise.
  void name_keeper(Side side, int number) { keepers_[side] = number; }

  // To be called once per frame, after the referee: `signal` is what it has just said.
  void see(const sim::World& world, const RefereeSignal& signal);
  // The same with touches and meetings apart, for staged games.
  void see(const sim::WorldState& now, std::span<const sim::Touch> touches,
           std::span<const sim::RobotCollision> collisions, const RefereeSignal& signal);

  // All so far, in the order of frames.
  const TrueEvents& true_events() const { return true_events_; }
  const Play& play() const { return play_.play(); }
  const BallHistory& ball() const { return ball_; }

 private:
  void write_message(const Scene& scene);
  void note_fouls(std::size_t from);

  Field field_;
  RuleBook rules_;
  double frame_s_;
  PlayFollower play_;
  BallHistory ball_;
  std::vector<std::unique_ptr<GroundTruthRule>> rules_of_truth_;
  sim::WorldState before_;
  RefereeSignal signal_;  // in force since the frame before
  bool has_begun_ = false;
  PerSide<int> keepers_;
  PerSide<double> fouled_s_;
  TrueEvents true_events_;
};

}  // namespace autoref::runner::ground_truth
