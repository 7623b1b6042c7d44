// What the referee's commands allow, and how the true ball enters play.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::judge::ground_truth {

// `restart` is the command that started play; for a kick-off or penalty its preparation.
struct Play {
  bool is_on = false;          // from the restart's signal until play is stopped
  bool is_stop = false;        // STOP is in force
  std::optional<Side> placer;  // the side that BALL_PLACEMENT tells to place the ball
  Command restart;
  std::optional<Side> taker;  // nullopt after a force start
  double began_s = 0;         // time of the restart's signal
  Vec2 ball_from_m{0, 0};     // position of the ball at that time
  bool in_play = false;       // the ball has moved far enough (RuleBook::in_play_m)
  bool entered_now = false;   // in this frame
  double entered_s = 0;
  double stopped_s = 0;   // when STOP was sent
  bool ends_now = false;  // the referee has just ended play
  int count = 0;          // number of commands obeyed; identifies a restart or stop
  int stops = 0;          // number of STOPs among them; the same in a stop and its restart
  // A repeated STOP continues the same stop; a free kick continues the stop before it.
  int stop_count = 0;
  double stop_began_s = 0;

  bool is_kickoff() const { return restart.kind == CommandKind::kPrepareKickoff; }
  bool is_penalty() const { return restart.kind == CommandKind::kPreparePenalty; }
};

// Follows a game. Commands sent before a frame are in force in it; commands sent in a frame are
// obeyed after it.
class PlayFollower {
 public:
  explicit PlayFollower(const RuleBook& rules) : in_play_m_(rules.in_play_m) {}

  // Call `update` before a frame's rules are evaluated, and `obey` afterwards.
  const Play& update(const sim::WorldState& now, double time_s, const RefereeSignal& signal);
  void obey(const sim::WorldState& now, double time_s, const RefereeSignal& signal);
  const Play& play() const { return play_; }

 private:
  double in_play_m_;
  Play play_;
  Command prepared_;
  std::uint32_t counter_ = 0;
};

}  // namespace autoref::judge::ground_truth
