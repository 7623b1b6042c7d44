#include "strategies/tactics/duel.hpp"

#include "soccer/robot_shape.hpp"
#include "strategies/skills/strike.hpp"

namespace autoref::strategies {
namespace {}  // namespace

bool opponent_has_ball(const PredictedState& predicted) {
  const int opponent = predicted.their_fastest();
  return opponent >= 0 && has_ball(predicted.now().opponents[static_cast<std::size_t>(opponent)],
                                   predicted.path().now_m());
}

RobotCommand block_ball(const PredictedState& predicted, int index) {
  const TrackedRobot& robot = predicted.robot(index);
  const auto opponent = static_cast<std::size_t>(predicted.their_fastest());
  const Vec2 ball_m = predicted.path().now_m() + predicted.now().opponents[opponent].velocity_mps *
                                                     predicted.style().block_lead_s;
  const Vec2 goal_m = predicted.field().goal_centre_m(Side::kWest);
  const Vec2 back = direction_of(goal_m - ball_m, Vec2(-1, 0));
  const Vec2 stand_m = ball_m + back * (kFrontDistance_m + kBallRadius_m);
  const Vec2 off = stand_m - robot.position_m;
  const DrivingStyle style = predicted.driving(index);
  RobotCommand command;
  if (off.norm() > predicted.style().block_from_m) {
    Obstacles obstacles;
    robots_around(predicted, index, stand_m, obstacles);
    command = drive_via(robot, steer_for(robot, stand_m, obstacles), {stand_m, -back}, style);
  } else {
    command = drive_with(
        robot, off * predicted.style().block_close_per_s - back * predicted.style().block_press_mps,
        -back, style);
  }
  // A ball that both robots hold would count as being dribbled.
  command.dribble = predicted.style().dribble_gap_m <= 0 ||
                    !predicted.rules().has(RuleId::kBotDribbledBallTooFar);
  return command;
}

RobotCommand FaceOff::break_away(double now_s) {
  if (now_s > until_s_) {
    until_s_ = now_s + predicted_.style().face_off_s;
    side_ = random_.uniform() < 0.5 ? 1.0 : -1.0;
  }
  RobotCommand command;
  command.velocity_mps =
      Vec2(predicted_.style().face_off_ahead_mps, side_ * predicted_.style().face_off_aside_mps);
  command.angular_velocity_radps = side_ * predicted_.style().face_off_turn_radps;
  command.dribble = true;
  return command;
}

}  // namespace autoref::strategies
