#include "game/loop/start_scene.hpp"

#include <utility>

#include "referee/event.hpp"

namespace autoref::game {
namespace {

template <typename T>
void swap_sides(PerSide<T>& values) {
  std::swap(values[Side::kWest], values[Side::kEast]);
}

// The signal as seen from the other end. Each team keeps its end of the real field, but changes its
// colour.
RefereeSignal mirrored_signal(RefereeSignal signal) {
  signal.command = mirrored(signal.command);
  if (signal.next_command) signal.next_command = mirrored(*signal.next_command);
  if (signal.placement) signal.placement->target_m = mirrored(signal.placement->target_m);
  swap_sides(signal.goals);
  swap_sides(signal.shootout_goals);
  swap_sides(signal.robots_allowed);
  swap_sides(signal.yellow_cards);
  swap_sides(signal.red_cards);
  swap_sides(signal.yellow_left_s);
  swap_sides(signal.fouls);
  swap_sides(signal.timeouts_left);
  swap_sides(signal.timeout_left_s);
  swap_sides(signal.keepers);
  swap_sides(signal.can_place_ball);
  signal.blue_on_positive_half = !signal.blue_on_positive_half;
  return signal;
}

referee::MidwayStart mirrored_referee_start(referee::MidwayStart start) {
  if (start.restart) start.restart = mirrored(*start.restart);
  start.ball_m = mirrored(start.ball_m);
  if (start.signal) start.signal = mirrored_signal(*start.signal);
  swap_sides(start.goals_in_earlier_halves);
  return start;
}

// The decision that stopped play in this frame, if any.
std::optional<SceneEnd> end_in(std::span<const referee::Decision> decisions) {
  for (const referee::Decision& decision : decisions) {
    if (decision.from == referee::State::kRun && decision.to != referee::State::kRun)
      return scene_end_by(decision.finding.event);
  }
  return std::nullopt;
}

}  // namespace

SceneEnd scene_end_by(referee::Event event) {
  const referee::EventEntry& entry = referee::entry_of(event);
  if (event == referee::Event::kGoal) return SceneEnd::kGoal;
  if (entry.is_exit) return SceneEnd::kBallOut;
  return entry.is_foul ? SceneEnd::kFoul : SceneEnd::kStop;
}

StartState mirrored(const StartState& state) {
  StartState other = state;
  swap_sides(other.robots);
  for (sim::RobotStates& robots : other.robots.values) {
    for (sim::RobotState& robot : robots) robot = mirrored(robot);
  }
  other.ball = mirrored(state.ball);
  other.referee = mirrored_referee_start(state.referee);
  for (Frame& frame : other.seen_before) frame = mirrored(frame);
  if (other.ghost) other.ghost = mirrored(*other.ghost);
  return other;
}

bool SceneFollower::keeps_ball(const RefereeSignal& signal) const {
  if (signal.command.kind == CommandKind::kGoal) return signal.command.side == attackers_;
  if (signal.next_command && is_for_one_side(signal.next_command->kind))
    return signal.next_command->side == attackers_;
  return !touched_ || *touched_ == attackers_;
}

// The touches of a frame happened before it.
void SceneFollower::update(const Input& input) {
  const double x_m = -goal_sign(attackers_) * input.world.ball.position_m.x();
  const bool is_play = input.state == referee::State::kRun;
  if (is_play && !began_s_) {
    began_s_ = input.time_s;
    from_m_ = x_m;
  }
  if (!began_s_ || is_over()) return;
  to_m_ = x_m;
  if (!input.touches.empty()) touched_ = input.touches.back().robot.side;
  is_kept_ = keeps_ball(input.signal);
  const std::optional<SceneEnd> end = end_in(input.decisions);
  if (end && scene_.is_ended_by(*end)) {
    ended_by_ = end;
  } else if (input.time_s >= *began_s_ + scene_.lasts_s) {
    ended_by_ = SceneEnd::kTime;
  }
}

SceneRecord SceneFollower::record(int goals, int goals_against, double xg) const {
  SceneRecord record;
  record.ended_by = ended_by_.value_or(SceneEnd::kStop);
  record.ball_kept = is_kept_;
  record.gained_m = to_m_ - from_m_;
  const SceneWeights& weights = scene_.weights;
  record.score = weights.goal * (goals > 0 ? 1 : 0) +
                 weights.conceded * (goals_against > 0 ? 1 : 0) +
                 weights.ball_kept * (record.ball_kept ? 1 : 0) +
                 weights.gained_m * record.gained_m + weights.xg * xg;
  return record;
}

}  // namespace autoref::game
