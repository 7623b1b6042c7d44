#include "game/loop/start_scene.hpp"

#include "referee/event.hpp"

namespace autoref::game {
namespace {

Vec2 turned(const Vec2& vector) { return Vec2(0, 0) - vector; }  // never -0

sim::RobotState turned(sim::RobotState robot) {
  robot.position_m = turned(robot.position_m);
  robot.heading = turned(robot.heading);
  robot.velocity_mps = turned(robot.velocity_mps);
  return robot;
}

SceneEnd end_by(referee::Event event) {
  const referee::EventEntry& entry = referee::entry_of(event);
  if (event == referee::Event::kGoal) return SceneEnd::kGoal;
  if (entry.is_exit) return SceneEnd::kBallOut;
  return entry.is_foul ? SceneEnd::kFoul : SceneEnd::kStop;
}

// The decision that stopped play in this frame, if any.
std::optional<SceneEnd> end_in(std::span<const referee::Decision> decisions) {
  for (const referee::Decision& decision : decisions) {
    if (decision.from == referee::State::kRun && decision.to != referee::State::kRun)
      return end_by(decision.finding.event);
  }
  return std::nullopt;
}

}  // namespace

StartState mirrored(const StartState& state) {
  StartState other = state;
  for (const Side side : kSides) {
    other.robots[side].clear();
    for (const sim::RobotState& robot : state.robots[opponent_of(side)])
      other.robots[side].push_back(turned(robot));
  }
  other.ball.position_m = turned(state.ball.position_m);
  other.ball.velocity_mps = turned(state.ball.velocity_mps);
  other.referee.ball_m = turned(state.referee.ball_m);
  if (other.referee.restart) other.referee.restart = mirrored(*other.referee.restart);
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
