#include "soccer/team_view.hpp"

namespace autoref {
namespace {

// West sees the field as it is; east sees it rotated by 180 degrees.
void fill_robots(const TrackedRobots& robots, Side viewer, TrackedRobots& seen) {
  seen.clear();
  for (const TrackedRobot& robot : robots) {
    seen.push_back(viewer == Side::kWest ? robot : mirrored(robot));
  }
}

}  // namespace

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
  // A shoot-out kick stays a penalty kick until it is over, so the other robots stay away until
  // then.
  if (signal.stage == Stage::kShootout) return situation_;
  if ((*ball_m - *restart_from_m_).norm() > in_play_m_) situation_.play = Play::kRunning;
  return situation_;
}

void fill_view(const Tracks& tracks, const RefereeSignal& signal, const Situation& situation,
               Side side, TeamView& view) {
  const bool as_is = side == Side::kWest;
  view.frame = tracks.frame;
  view.time_s = tracks.time_s;
  fill_robots(tracks.robots[side], side, view.own);
  fill_robots(tracks.robots[opponent_of(side)], side, view.opponents);
  const TrackedBall ball = tracks.ball.value_or(TrackedBall{});
  view.ball = as_is ? ball : mirrored(ball);
  view.play = situation.play;
  view.ours =
      situation.side == side && situation.play > Play::kStop && situation.play != Play::kRunning;
  view.placement_m.reset();
  if (signal.placement) {
    view.placement_m = as_is ? signal.placement->target_m : Vec2(-signal.placement->target_m);
  }
  view.placing_is_ours.reset();
  if (situation.placer) view.placing_is_ours = *situation.placer == side;
  view.next.reset();
  view.next_is_ours = false;
  if (situation.play == Play::kStop && signal.next_command) {
    view.next = signal.next_command->kind;
    view.next_is_ours = is_for_one_side(*view.next) && signal.next_command->side == side;
  }
  view.goals_own = signal.goals[side];
  view.goals_opponent = signal.goals[opponent_of(side)];
  view.stage_time_left_s = signal.stage_time_left_s;
}

}  // namespace autoref
