// The machine's state: all the data it keeps between frames.
#pragma once

#include <boost/container/static_vector.hpp>
#include <limits>
#include <optional>

#include "referee/decision.hpp"
#include "referee/machine/rule_watch.hpp"
#include "referee/state.hpp"
#include "referee/touch/touch_history.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

inline constexpr int kMaxHalves = 4;  // two halves and two halves of extra time

// "AutoRef saves the current positions of the robots" (paper, section 4.4).
struct SavedPositions {
  PerSide<SeenRobots> robots;
  double time_s = 0;
};

// The current phase of play. Meaningless outside RUN.
struct PlayState {
  Command began_with;  // NORMAL_START, a free kick or FORCE_START
  Command restart;     // the command that repeats this restart: either the same one or its PREPARE
                       // command
  Vec2 position_m{0, 0};            // where the ball was placed for the restart
  std::optional<Side> kicker;       // the side that takes the restart; nullopt after a force start
  double began_s = 0;               // when the restart was signalled
  std::optional<Vec2> ball_from_m;  // where the ball was at `began_s`; nullopt until it is seen
  double moved_m = 0;               // largest distance of the ball from there
  bool lies_outside = false;        // the ball was seen outside the field at `began_s`, and has not
                                    // been seen on it since
  bool in_play = false;             // the ball has moved, or need not move for this restart
  bool entered_now = false;         // the ball entered play in this frame
  double in_play_since_s = 0;       // meaningless until the ball is in play
  // When the kick that took the restart was over. After that, a touch by the kicker before any
  // other robot's is a double touch.
  std::optional<double> kick_ended_s;
  TouchHistory touches;   // touches since play began
  Vec2 stuck_at_m{0, 0};  // the ball has stayed near this position since `stuck_since_s`
  double stuck_since_s = 0;
  // Only at penalty kicks: how far the ball has got towards the goal, and the sides that have
  // committed a foul that can decide the kick.
  double farthest_m = -std::numeric_limits<double>::infinity();
  PerSide<bool> has_fouled;

  // Whether fouls by this side alone decide the penalty kick.
  bool is_decided_by_foul_of(Side side) const {
    return has_fouled[side] && !has_fouled[opponent_of(side)];
  }
  bool is_kickoff() const { return restart.kind == CommandKind::kPrepareKickoff; }
  bool is_penalty() const { return restart.kind == CommandKind::kPreparePenalty; }
};

// How often a restart was retaken because its own rules were broken.
struct Retakes {
  int count = 0;      // number of retakes
  RobotSet too_near;  // opponents that were too near to the ball
};

// Total of several time spans.
struct Stopwatch {
  double before_s = 0;            // total of the finished spans
  std::optional<double> since_s;  // start of the running span, if any

  double running_s(double now_s) const { return since_s ? now_s - *since_s : 0; }
  double at_s(double now_s) const { return before_s + running_s(now_s); }
  void start(double now_s) { since_s = now_s; }
  void stop(double now_s) {
    before_s = at_s(now_s);
    since_s.reset();
  }
};

// A side's fouls and cards.
struct CardBook {
  int fouls = 0;                   // only those that count towards a card
  int cards_for_fouls = 0;         // cards shown for these fouls
  std::optional<double> fouled_s;  // when the last non-stopping foul was called
  // When the active yellow cards end, in terms of the play clock, oldest first.
  boost::container::static_vector<double, kMaxRobots> yellow_ends_s;
  std::optional<double> fewer_since_s;     // when the number of robots allowed last changed
  std::optional<double> too_many_since_s;  // when the side began to have too many robots on the
                                           // field
  bool too_many_called = false;            // whether this was called since the number allowed last
                                           // changed
};

// The timeouts that a side has taken since the start of the game, or of extra time.
struct TimeoutBook {
  int taken = 0;
  double used_s = 0;  // time used in finished timeouts
};

// The kicks of a shoot-out.
struct ShootoutBook {
  PerSide<int> kicks;
  PerSide<int> goals;
};

// How the ball gets to the next restart's position.
enum class PlacementStep : std::uint8_t {
  kNone,       // placed by hand, or already at its position
  kUndecided,  // a team has to place it, but has not yet been ordered to
  kByTeam,     // placed by the team's robots
  kStays,      // near enough to its position to stay where it is
  kByHand,     // placed by hand: the robots cannot reach it, or may not place it
};

// Ball placement by the teams' robots (2026).
struct TeamPlacement {
  PlacementStep step = PlacementStep::kNone;
  Side side = Side::kWest;   // the side that has to place the ball
  Command restart;           // the restart as first given, before a failed placement changed it
  PerSide<bool> has_failed;  // whether the side has failed to place the ball for this restart
  Vec2 target_m{0, 0};       // the designated position
  // Distance from the ball to `target_m` when the side was ordered to place it.
  double distance_m = 0;
  Vec2 mark_m{0, 0};  // the ball has stayed near this position since `still_since_s`
  double still_since_s = 0;
};

struct RefereeState {
  State machine_state = State::kInit;
  std::optional<MidwayStart> midway_start;  // nullopt if the game begins with the first kick-off
  RefereeSignal signal;  // the signal in force; includes score, placement and the paper's `next`

  double wait_began_s = 0;  // in WAIT_START and WAIT_STOP: when the wait, and so its timeout, began
  SavedPositions saved;     // reference positions for detecting whether robots move
  double checked_s = 0;     // when the positions were last compared
  std::optional<double> ball_in_position_since_s;
  double delay_ends_s = 0;  // in DELAY_WAIT: when the delay ends
  PlayState play;
  RuleWatch watch;          // the rules' records since play last started or stopped
  Stopwatch play_clock;     // time spent in RUN, over all halves
  Stopwatch timeout_clock;  // time spent in timeouts
  PerSide<CardBook> cards;
  std::optional<Command> prepared;  // the kick-off or penalty that NORMAL_START will start
  Retakes retakes;                  // how often the current or next restart has been retaken
  PerSide<TimeoutBook> timeouts;
  Side timeout_side = Side::kWest;  // the side that takes the timeout; meaningless outside TIMEOUT
  ShootoutBook shootout;

  int half = 0;             // the current or next half, counted from 0
  double half_began_s = 0;  // start of the half, on the clock of clock_s() (guards.hpp)
  int games_finished = 0;
  boost::container::static_vector<PerSide<int>, kMaxHalves> goals_by_half{PerSide<int>{}};

  TeamPlacement placing;
  PerSide<int> placement_failures;  // failed placements in this half; each success subtracts one
};

}  // namespace autoref::referee
