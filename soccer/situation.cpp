#include "soccer/situation.hpp"

namespace autoref {

void SituationTracker::obey(const Command& command) {
  situation_.placer.reset();
  switch (command.kind) {
    case CommandKind::kHalt:
      situation_.play = Play::kHalt;
      return;
    case CommandKind::kNormalStart:
      if (situation_.play == Play::kPrepareKickoff) situation_.play = Play::kKickoff;
      if (situation_.play == Play::kPreparePenalty) situation_.play = Play::kPenalty;
      return;
    case CommandKind::kForceStart:
      situation_.play = Play::kRunning;
      return;
    case CommandKind::kPrepareKickoff:
      situation_ = {Play::kPrepareKickoff, command.side};
      return;
    case CommandKind::kPreparePenalty:
      situation_ = {Play::kPreparePenalty, command.side};
      return;
    case CommandKind::kDirectFree:
      situation_ = {Play::kDirectFree, command.side};
      return;
    case CommandKind::kIndirectFree:
      situation_ = {Play::kIndirectFree, command.side};
      return;
    case CommandKind::kStop:
    case CommandKind::kTimeout:
    case CommandKind::kGoal:
      situation_.play = Play::kStop;
      return;
    case CommandKind::kBallPlacement:
      situation_.play = Play::kStop;
      situation_.placer = command.side;
      return;
  }
}

Situation SituationTracker::update(const RefereeSignal& signal, const std::optional<Vec2>& ball_m) {
  if (signal.command_counter != obeyed_counter_) {
    obeyed_counter_ = signal.command_counter;
    restart_from_m_.reset();
    obey(signal.command);
  }
  if (!is_restart(situation_.play) || !ball_m) return situation_;
  // The ball is in play once it has moved far enough from where it was first seen after the
  // command.
  if (!restart_from_m_) restart_from_m_ = *ball_m;
  // A shoot-out kick stays a penalty kick until it is over, so the other robots stay out of it.
  if (signal.stage == Stage::kShootout) return situation_;
  if ((*ball_m - *restart_from_m_).norm() > in_play_m_) situation_.play = Play::kRunning;
  return situation_;
}

}  // namespace autoref
