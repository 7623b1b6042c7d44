#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kFirst_mps = 0.9;
constexpr double kSecond_mps = 3.0;
constexpr double kAway_m = 150_mm;  // distance from the robot's centre to a ball that has left it
constexpr double kRolls_mps = 0.3;
constexpr double kMates_m = 1.5;  // distance kept by team-mates

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_own_restart(view)) return std::nullopt;
  return foul_by(nearest_mate(view, view.now.ball.position_m, view.field.length_m),
                 view.now.ball.position_m);
}

// The robot kicks softly, then follows the ball.
bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const TrackedRobot& robot = *find(view.now.own, foul.robot);
  const TrackedBall& ball = view.now.ball;
  const Vec2 target_m(view.field.half_length_m() / 2, 0);
  const bool is_away = (ball.position_m - robot.position_m).norm() > kAway_m;
  const bool has_kicked = ball.velocity_mps.norm() > kRolls_mps;
  foul.is_halfway = foul.is_halfway || (is_running(view) && is_away);
  hold_back(view, foul.robot, ball.position_m, kMates_m, output.commands);
  RobotCommand& command = output.command(foul.robot);
  command = kick_at(view, robot, target_m, foul.is_halfway ? kSecond_mps : kFirst_mps);
  if (has_kicked && !foul.is_halfway) command = RobotCommand{};
  if (is_running(view)) return ball.velocity_mps.norm() < kSecond_mps / 2;
  return is_own_restart(view);
}

}  // namespace

const FoulBehaviour kSecondTouch = {
    "second_touch", "The kicker of a restart plays the ball twice.", 0.2, 12, find_chance, go_on};

}  // namespace autoref::strategies::rowdy
