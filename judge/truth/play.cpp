#include "judge/truth/play.hpp"

namespace autoref::judge::ground_truth {
namespace {

bool starts_play(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

bool is_free_kick(CommandKind kind) {
  return kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

bool prepares(CommandKind kind) {
  return kind == CommandKind::kPrepareKickoff || kind == CommandKind::kPreparePenalty;
}

}  // namespace

const Play& PlayFollower::update(const sim::WorldState& now, double time_s,
                                 const RefereeSignal& signal) {
  play_.entered_now = false;
  if (play_.is_on && !play_.in_play &&
      (now.ball.position_m - play_.ball_from_m).norm() > in_play_m_) {
    play_.in_play = true;
    play_.entered_now = true;
    play_.entered_s = time_s;
  }
  play_.ends_now =
      play_.is_on && signal.command_counter != counter_ && !starts_play(signal.command.kind);
  return play_;
}

void PlayFollower::obey(const sim::WorldState& now, double time_s, const RefereeSignal& signal) {
  if (signal.command_counter == counter_) return;
  counter_ = signal.command_counter;
  const Command& command = signal.command;
  if (prepares(command.kind)) prepared_ = command;
  const Play before = play_;
  play_ = Play{};
  play_.is_on = starts_play(command.kind);
  play_.is_stop = command.kind == CommandKind::kStop;
  if (command.kind == CommandKind::kBallPlacement) play_.placer = command.side;
  play_.count = before.count + 1;
  play_.stops = before.stops + (play_.is_stop ? 1 : 0);
  play_.stopped_s = time_s;
  play_.stop_count = before.stop_count;
  play_.stop_began_s = before.stop_began_s;
  if (!before.is_stop && (play_.is_stop || is_free_kick(command.kind))) {
    ++play_.stop_count;
    play_.stop_began_s = time_s;
  }
  if (!play_.is_on) return;
  play_.restart = command.kind == CommandKind::kNormalStart ? prepared_ : command;
  if (is_for_one_side(play_.restart.kind)) play_.taker = play_.restart.side;
  play_.began_s = time_s;
  play_.ball_from_m = now.ball.position_m;
  play_.in_play = command.kind == CommandKind::kForceStart;
  play_.entered_s = time_s;
}

}  // namespace autoref::judge::ground_truth
