// The newest message of the league's game controller, as the signal of a simulated game.
#pragma once

#include "game/loop/game_configuration.hpp"
#include "league/messages/referee.pb.h"
#include "referee/referee_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {

// Whether a restart is still to come after a command of this kind.
bool is_before_restart(CommandKind kind);

// The signal of a game in which a person places the ball.
RefereeSignal with_ball_placed_by_hand(RefereeSignal signal);

class FollowedSignal {
 public:
  explicit FollowedSignal(const game::GameConfiguration& game)
      : placed_by_(game.match.placement), field_(game.field) {}

  // Takes a message. `now_s` is the time in the game. Returns false, without any other effect, if
  // the message has an unknown command or stage.
  bool take(const league::RefereePacket& packet, double now_s);

  // The newest message; empty before the first one.
  const league::RefereePacket& packet() const { return packet_; }

  // The signal in it, in the program's coordinates and with times on the game's clock. If the teams
  // place the ball, it is left to them unless it is a kick-off or penalty kick that is next.
  const RefereeSignal& signal() const { return signal_; }

 private:
  referee::PlacedBy placed_by_;
  Field field_;
  league::RefereePacket packet_;
  RefereeSignal signal_;
};

}  // namespace autoref::live
