// Observes the exact state of a game and records the events that happened according to the rules.
//
// The observer follows the referee's commands, which determine when play is on and who takes a
// restart. The observer ignores the referee's calls. Field and ball are taken from the simulated
// world.
#pragma once

#include <memory>
#include <vector>

#include "judge/truth/true_frame.hpp"

namespace autoref::judge::ground_truth {

class GroundTruthObserver {
 public:
  GroundTruthObserver(const Field& field, const RuleBook& rules, double frame_rate_hz);

  // Sets the keeper's number; initially 0.
  void name_keeper(Side side, int number) { keepers_[side] = number; }

  // Call once per frame, after the referee; `signal` is its latest signal.
  void see(const sim::World& world, const RefereeSignal& signal);
  // Like the function above, but with touches and collisions given separately, for staged games.
  void see(const sim::WorldState& now, std::span<const sim::Touch> touches,
           std::span<const sim::RobotCollision> collisions, const RefereeSignal& signal);

  // All events so far, in order of frames.
  const TrueEvents& true_events() const { return true_events_; }
  const TruePlay& play() const { return play_.play(); }
  const BallHistory& ball() const { return ball_; }

 private:
  void write_message(const TrueFrame& frame);
  void note_fouls(std::size_t from);

  Field field_;
  RuleBook rules_;
  double frame_s_;
  PlayFollower play_;
  BallHistory ball_;
  std::vector<std::unique_ptr<GroundTruthRule>> rules_of_truth_;
  sim::WorldState before_;
  RefereeSignal signal_;  // signal in force since the previous frame
  bool has_begun_ = false;
  PerSide<int> keepers_;
  PerSide<double> fouled_s_;
  TrueEvents true_events_;
};

}  // namespace autoref::judge::ground_truth
