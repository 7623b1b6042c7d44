// Everything the referee's machine remembers from one frame to the next.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/decision.hpp"
#include "referee/machine/rule_watch.hpp"
#include "referee/touch/touch_history.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

inline constexpr int kMaxHalves = 4;  // two halves and two of extra time: more have no stage

// "AutoRef saves the current positions of the robots" (paper, section 4.4).
struct SavedPositions {
  PerSide<SeenRobots> robots;
  double time_s = 0;
};

// How the play that is on began. Means nothing outside RUN.
struct PlayState {
  Command began_with;               // NORMAL_START after a preparation, a free kick, FORCE_START
  Command restart;                  // the same, or that preparation: what takes it again
  Vec2 position_m{0, 0};            // where the ball was to be put for it
  std::optional<Side> kicker;       // who takes the restart; none after a force start
  double began_s = 0;               // when it was signalled
  std::optional<Vec2> ball_from_m;  // where the ball lay then; none while it was never seen
  bool in_play = false;             // the ball has moved, or needs not
  bool entered_now = false;         // in this frame, by the kicker's restart
  double in_play_since_s = 0;       // means nothing before the ball is in play
  TouchHistory touches;             // since it began
  Vec2 stuck_at_m{0, 0};            // the ball has been about here
  double stuck_since_s = 0;         // since then

  bool is_kickoff() const { return restart.kind == CommandKind::kPrepareKickoff; }
  bool is_penalty() const { return restart.kind == CommandKind::kPreparePenalty; }
};

// Of one restart, as long as it is taken again for breaches of its own rules.
struct Retakes {
  int count = 0;      // how often it has been
  RobotSet too_near;  // opponents who were too near to the ball then
};

// Adds up spells of time.
struct Stopwatch {
  double before_s = 0;            // of the spells that are over
  std::optional<double> since_s;  // when the spell that is on began

  double at_s(double now_s) const { return before_s + (since_s ? now_s - *since_s : 0); }
  void start(double now_s) { since_s = now_s; }
  void stop(double now_s) {
    before_s = at_s(now_s);
    since_s.reset();
  }
};

// A side's fouls and cards.
struct CardBook {
  int fouls = 0;                   // that count towards a card
  int cards_for_fouls = 0;         // shown for them
  std::optional<double> fouled_s;  // when the last non-stopping foul was called
  // When the active yellow cards are over, by the play clock; the oldest first.
  boost::container::static_vector<double, kMaxRobots> yellow_ends_s;
  std::optional<double> fewer_since_s;     // when fewer robots were allowed, the last time
  std::optional<double> too_many_since_s;  // seen on the field
  bool too_many_called = false;            // since then
};

// The timeouts that a side has had: since the game's beginning, or extra time's.
struct TimeoutBook {
  int taken = 0;
  double used_s = 0;  // in those that are over
};

// The kicks of a shoot-out.
struct ShootoutBook {
  PerSide<int> kicks;
  PerSide<int> goals;
};

struct RefereeState {
  State machine_state = State::kInit;
  RefereeSignal signal;  // in force: command, stage, score, placement, and the paper's `next`

  double wait_began_s = 0;  // in WAIT_START, WAIT_STOP: the timeout runs from here
  SavedPositions saved;     // what the robots' position are compared with
  double checked_s = 0;     // when they were compared last
  std::optional<double> ball_in_position_since_s;
  double delay_ends_s = 0;  // in DELAY_WAIT
  PlayState play;
  RuleWatch watch;          // of the rules, since play last started or stopped
  Stopwatch play_clock;     // the time spent in RUN, all halves together
  Stopwatch timeout_clock;  // and in timeouts
  PerSide<CardBook> cards;
  std::optional<Command> prepared;  // the kick-off or penalty that NORMAL_START starts
  Retakes retakes;                  // of the restart that is on, or comes next
  PerSide<TimeoutBook> timeouts;
  Side timeout_side = Side::kWest;  // whose timeout is on; means nothing outside TIMEOUT
  ShootoutBook shootout;

  int half = 0;             // running or next, counted from 0
  double half_began_s = 0;  // when its clock started, by clock_s() of timekeeping.hpp
  int games_finished = 0;
  boost::container::static_vector<PerSide<int>, kMaxHalves> goals_by_half{PerSide<int>{}};
};

}  // namespace autoref::referee
