// The game as one team sees it. Every team sees its own goal at -x and +y to its left, whichever
// side it plays on; the turning is done here and nowhere else.
#pragma once

#include <cstdint>

#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/situation.hpp"
#include "soccer/tracks.hpp"

namespace autoref {

struct TeamView {
  std::int64_t frame = 0;  // number of the camera frame this view is made of
  double time_s = 0;       // when that frame was taken
  double latency_s = 0;    // from the frame until an order given now moves a robot
  TrackedRobots own;
  TrackedRobots opponents;
  TrackedBall ball;
  Play play = Play::kHalt;
  bool ours = false;  // whether the restart at hand is this team's
  // Where the referee puts the ball for the next restart, while play is stopped.
  std::optional<Vec2> placement_m;
  // What play goes on with after this stop, as far as it is known, and whether it is this team's.
  std::optional<CommandKind> next;
  bool next_is_ours = false;
  int goals_own = 0;
  int goals_opponent = 0;
  double stage_time_left_s = 0;
};

// `tracks` and `signal`, which are in the field's frame, as the team on `side` sees them. Fills
// `view` in place: nothing is allocated.
void fill_view(const Tracks& tracks, const RefereeSignal& signal, const Situation& situation,
               Side side, TeamView& view);

}  // namespace autoref
