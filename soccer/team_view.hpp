// The game as one team sees it. Every team sees its own goal at -x and +y to its left, whichever
// side it plays on; only this code rotates the view.
#pragma once

#include <cstdint>

#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/situation.hpp"
#include "soccer/tracks.hpp"

namespace autoref {

struct TeamView {
  std::int64_t frame = 0;  // number of the camera frame behind this view
  double time_s = 0;       // capture time of that frame
  double latency_s = 0;    // from the frame until a command moves a robot, as the team believes
  TrackedRobots own;
  TrackedRobots opponents;
  TrackedBall ball;
  Play play = Play::kHalt;
  bool ours = false;  // whether the current restart is this team's
  // Where the referee places the ball for the next restart; set while play is stopped.
  std::optional<Vec2> placement_m;
  // Whether the robots of a team place the ball there now; then whether they are this team's. The
  // placing team brings the ball there, and the other keeps clear of its path.
  std::optional<bool> placing_is_ours;
  // The restart after this stop, if known, and whether it is this team's.
  std::optional<CommandKind> next;
  bool next_is_ours = false;
  int goals_own = 0;
  int goals_opponent = 0;
  double stage_time_left_s = 0;
};

// Fills `view` with `tracks` and `signal`, which are in field coordinates, as the team on `side`
// sees them. Allocates nothing.
void fill_view(const Tracks& tracks, const RefereeSignal& signal, const Situation& situation,
               Side side, TeamView& view);

}  // namespace autoref
