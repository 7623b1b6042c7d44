#include "game/loop/start_state.hpp"

namespace autoref::game {
namespace {

Vec2 turned(const Vec2& vector) { return Vec2(0, 0) - vector; }  // never -0

sim::RobotState turned(sim::RobotState robot) {
  robot.position_m = turned(robot.position_m);
  robot.heading = turned(robot.heading);
  robot.velocity_mps = turned(robot.velocity_mps);
  return robot;
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

}  // namespace autoref::game
