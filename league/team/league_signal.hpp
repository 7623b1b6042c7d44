// The referee's signal, for teams that only know the league's messages.
#pragma once

#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"
#include "soccer/team_view.hpp"

namespace autoref::league {

// Reconstructs from a team's views what the referee has sent. A view contains neither cards nor
// whether a team may place the ball; the half is inferred from the time left in it.
class LeagueSignal {
 public:
  // `side` is the team's side.
  LeagueSignal(Side side, int robots);

  // Call it once per frame. The signal's positions are in field coordinates.
  const RefereeSignal& update(const TeamView& view);

  const RefereeSignal& signal() const { return signal_; }

 private:
  Command command_of(const TeamView& view) const;
  CommandKind kind_in_running_play() const;
  Stage stage_of(const TeamView& view) const;
  Side side_of(bool ours) const { return ours ? side_ : opponent_of(side_); }

  Side side_;
  RefereeSignal signal_;
  Play play_ = Play::kHalt;  // the state of play in the last view
  std::size_t halves_ = 0;   // number of halves that have begun
};

}  // namespace autoref::league
