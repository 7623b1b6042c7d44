#include "live/controller/followed_signal.hpp"

#include <optional>
#include <utility>

#include "league/referee_message.hpp"
#include "referee/machine/ball_placement.hpp"

namespace autoref::live {

bool is_before_restart(CommandKind kind) {
  return kind == CommandKind::kHalt || kind == CommandKind::kStop ||
         kind == CommandKind::kPrepareKickoff || kind == CommandKind::kPreparePenalty ||
         kind == CommandKind::kBallPlacement;
}

RefereeSignal with_ball_placed_by_hand(RefereeSignal signal) {
  if (signal.placement) signal.placement->by_hand = true;
  return signal;
}

bool FollowedSignal::take(const league::RefereePacket& packet, double now_s) {
  std::optional<RefereeSignal> given = league::signal_of(packet);
  if (!given) return false;
  packet_ = packet;
  const bool is_new =
      given->command_counter != signal_.command_counter || given->command != signal_.command;
  const double command_s = is_new ? now_s : signal_.command_time_s;
  signal_ = published(*std::move(given));
  signal_.command_time_s = command_s;
  // The controller also names a position during play.
  if (!is_before_restart(signal_.command.kind)) signal_.placement.reset();
  if (!signal_.placement) return true;
  const std::optional<Command>& next = signal_.next_command;
  const bool teams_place = placed_by_ == referee::PlacedBy::kTeams &&
                           (signal_.command.kind == CommandKind::kBallPlacement || !next ||
                            referee::is_placed_by_team(next->kind));
  signal_.placement->target_m = inside_walls(field_, signal_.placement->target_m);
  signal_.placement->by_hand = !teams_place;
  return true;
}

}  // namespace autoref::live
