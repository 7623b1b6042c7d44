// What the referee's commands allow, and how the true ball comes into play.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::runner::ground_truth {

// `restart` is what play was started with: a kick-off or penalty by its preparation.
struct Play {
  bool is_on = false;    // from a restart's signal until play is stopped
  bool is_stop = false;  // STOP is in force
  Command restart;
  std::optional<Side> taker;  // none after a force start
  double began_s = 0;         // of the restart's signal
  Vec2 ball_from_m{0, 0};     // where the ball was then
  bool in_play = false;       // it has moved far enough (RuleBook::in_play_m)
  bool entered_now = false;   // in this very frame
  double entered_s = 0;
  double stopped_s = 0;   // when STOP was sent
  bool ends_now = false;  // the referee has just ended play
  int count = 0;          // commands obeyed: tells one restart or stop from the next
  int stops = 0;          // STOPs among them: tells a stop and the restart after it from the next
  // A STOP that is sent again goes on with the stop; a free kick goes on with the one before it.
  int stop_count = 0;
  double stop_began_s = 0;

  bool is_kickoff() const { return restart.kind == CommandKind::kPrepareKickoff; }
  bool is_penalty() const { return restart.kind == CommandKind::kPreparePenalty; }
};

// Follows a game. What is in force in a frame was sent before it; what the referee sends in that
// frame is obeyed after it.
class PlayFollower {
 public:
  explicit PlayFollower(const RuleBook& rules) : in_play_m_(rules.in_play_m) {}

  // To be called before the frame's truths are told, and `obey` after them.
  const Play& update(const sim::WorldState& now, double time_s, const RefereeSignal& signal);
  void obey(const sim::WorldState& now, double time_s, const RefereeSignal& signal);
  const Play& play() const { return play_; }

 private:
  double in_play_m_;
  Play play_;
  Command prepared_;
  std::uint32_t counter_ = 0;
};

}  // namespace autoref::runner::ground_truth
