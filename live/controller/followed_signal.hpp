// The newest message of the league's game controller, as the signal of a simulated game.
#pragma once

#include "league/messages/referee.pb.h"
#include "referee/referee_configuration.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {

// Whether a restart is still to come after a command of this kind.
bool is_before_restart(CommandKind kind);

class FollowedSignal {
 public:
  explicit FollowedSignal(referee::PlacedBy placed_by) : placed_by_(placed_by) {}

  // Takes a message. `now_s` is the time in the game. `places_ball`: the ball is placed by hand
  // even where this is left to the teams. Returns false, without any other effect, if the message
  // has an unknown command or stage.
  bool take(const league::RefereePacket& packet, double now_s, bool places_ball);

  // The newest message; empty before the first one.
  const league::RefereePacket& packet() const { return packet_; }

  // The signal in it, in the program's coordinates and with times on the game's clock.
  const RefereeSignal& signal() const { return signal_; }

 private:
  referee::PlacedBy placed_by_;
  league::RefereePacket packet_;
  RefereeSignal signal_;
};

}  // namespace autoref::live
