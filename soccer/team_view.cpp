#include "soccer/team_view.hpp"

namespace autoref {
namespace {

// West sees the field as it is, east rotated by 180 degrees.
void fill_robots(const TrackedRobots& robots, Side viewer, TrackedRobots& seen) {
  seen.clear();
  for (const TrackedRobot& robot : robots) {
    seen.push_back(viewer == Side::kWest ? robot : mirrored(robot));
  }
}

}  // namespace

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
