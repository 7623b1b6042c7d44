// Everything the referee's machine remembers from one frame to the next.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/decision.hpp"
#include "referee/rule_watch.hpp"
#include "referee/touch_history.hpp"
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
struct PlayMemory {
  Command began_with;               // NORMAL_START after a preparation, a free kick, FORCE_START
  std::optional<Side> kicker;       // who takes the restart; none after a force start
  double began_s = 0;               // when it was signalled
  std::optional<Vec2> ball_from_m;  // where the ball lay then; none while it was never seen
  bool in_play = false;             // the ball has moved, or needs not
  bool entered_now = false;         // in this frame, by the kicker's restart
  double in_play_since_s = 0;       // means nothing before the ball is in play
  TouchHistory touches;             // since it began
  Vec2 stuck_at_m{0, 0};            // the ball has been about here
  double stuck_since_s = 0;         // since then
};

// A side's fouls and cards.
struct CardBook {
  int fouls = 0;                                                      // that count towards a card
  int yellows_for_fouls = 0;                                          // shown for them
  std::optional<double> fouled_s;                                     // when one was noted last
  boost::container::static_vector<double, kMaxRobots> yellow_left_s;  // of play, of active ones
};

struct Memory {
  State state = State::kInit;
  RefereeSignal signal;  // in force: command, stage, score, placement, and the paper's `next`

  double wait_began_s = 0;  // in WAIT_START, WAIT_STOP: the timeout runs from here
  SavedPositions saved;     // what the robots' places are compared with
  double looked_s = 0;      // when they were compared last
  std::optional<double> ball_in_place_since_s;
  double delay_ends_s = 0;  // in DELAY_WAIT
  PlayMemory play;
  RuleWatch watch;  // of the rules, since play last started or stopped
  PerSide<CardBook> cards;
  std::optional<Side> prepared_kicker;  // of the kick-off or penalty that NORMAL_START starts

  int half = 0;             // running or next, counted from 0
  double half_began_s = 0;  // when its clock started
  int games_finished = 0;
  boost::container::static_vector<PerSide<int>, kMaxHalves> goals_by_half{PerSide<int>{}};
};

}  // namespace autoref::referee
