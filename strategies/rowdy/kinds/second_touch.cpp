#include "strategies/rowdy/kinds.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kFirst_mps = 0.9;
constexpr double kSecond_mps = 3.0;
constexpr double kAway_m = 150_mm;  // from the robot's centre to a ball that has left it
constexpr double kRolls_mps = 0.3;
constexpr double kMates_m = 1.5;  // they keep this far off

std::optional<Deed> find_chance(const Scene& scene) {
  if (!is_own_restart(scene)) return std::nullopt;
  return deed_of(nearest_mate(scene, scene.now.ball.position_m, scene.field.length_m),
                 scene.now.ball.position_m);
}

// A soft kick, then after the ball.
bool go_on(const Scene& scene, Deed& deed, Will& will) {
  const TrackedRobot& robot = *find(scene.now.own, deed.robot);
  const TrackedBall& ball = scene.now.ball;
  const Vec2 target_m(scene.field.half_length_m() / 2, 0);
  const bool is_away = (ball.position_m - robot.position_m).norm() > kAway_m;
  const bool has_kicked = ball.velocity_mps.norm() > kRolls_mps;
  deed.is_halfway = deed.is_halfway || (is_running(scene) && is_away);
  hold_back(scene, deed.robot, ball.position_m, kMates_m, will.orders);
  RobotCommand& order = will.order(deed.robot);
  order = kick_at(scene, robot, target_m, deed.is_halfway ? kSecond_mps : kFirst_mps);
  if (has_kicked && !deed.is_halfway) order = RobotCommand{};
  if (is_running(scene)) return ball.velocity_mps.norm() < kSecond_mps / 2;
  return is_own_restart(scene);
}

}  // namespace

const Mischief kSecondTouch = {
    "second_touch", "The kicker of a restart plays the ball twice.", 0.2, 12, find_chance, go_on};

}  // namespace autoref::strategies::rowdy
