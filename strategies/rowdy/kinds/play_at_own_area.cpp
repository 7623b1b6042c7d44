#include "strategies/rowdy/kinds.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kShallow_m =
    20_mm;  // so deep in the area a robot outside of the ball is partly in
constexpr double kDeep_m = 120_mm;
constexpr double kReach_m = 1.5;
constexpr double kSlow_mps = 0.3;
constexpr double kRunUp_m = 180_mm;  // from the ball to the robot's centre
constexpr double kThere_m = 40_mm;
constexpr double kPush_mps = 0.4;
constexpr double kPushed_m = 30_mm;

std::optional<Deed> find_chance(const Scene& scene) {
  const TrackedBall& ball = scene.now.ball;
  const double inside_m = -distance_to_defence_area(scene.field, Side::kWest, ball.position_m);
  if (!is_running(scene) || inside_m < kShallow_m || inside_m > kDeep_m) return std::nullopt;
  if (ball.velocity_mps.norm() > kSlow_mps) return std::nullopt;
  return deed_of(nearest_mate(scene, ball.position_m, kReach_m), ball.position_m);
}

// Comes from outside and pushes the ball a little towards its own goal.
bool go_on(const Scene& scene, Deed& deed, Will& will) {
  const TrackedRobot& robot = *find(scene.now.own, deed.robot);
  const Vec2& ball_m = scene.now.ball.position_m;
  const Vec2 outwards = direction_of(ball_m - scene.field.goal_centre_m(Side::kWest), Vec2(1, 0));
  const Vec2 run_up_m = ball_m + outwards * kRunUp_m;
  hold_back(scene, deed.robot, ball_m, kReach_m, will.orders);
  deed.is_halfway = deed.is_halfway || (robot.position_m - run_up_m).norm() < kThere_m;
  will.order(deed.robot) =
      deed.is_halfway ? charge(robot, -outwards * kPush_mps) : go_to(scene, robot, run_up_m);
  return is_running(scene) && (ball_m - deed.from_m).norm() < kPushed_m;
}

}  // namespace

const Mischief kPlayAtOwnArea = {"play_at_own_area",
                                 "A field player partly inside its own area touches the ball.",
                                 0.3,
                                 5,
                                 find_chance,
                                 go_on};

}  // namespace autoref::strategies::rowdy
