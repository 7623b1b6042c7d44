#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

// Depths of the ball in the area at which a robot next to it can be partly inside: one range is for
// a robot on the field side of the ball, the other for a robot on the goal side.
constexpr double kDeepest_m = 120_mm;
constexpr double kFromOutside_m = 20_mm;
constexpr double kFromInside_m = -20_mm;
constexpr double kShallowest_m = -75_mm;
constexpr double kReach_m = 1.5;
constexpr double kSlow_mps = 0.5;
constexpr double kRunUp_m = 180_mm;  // distance from the ball to the robot's centre
constexpr double kThere_m = 40_mm;
constexpr double kPush_mps = 0.4;
constexpr double kPushed_m = 30_mm;
constexpr double kKick_mps = 2.0;
constexpr double kKicked_mps = 1.0;

double depth_m(const RowdyView& view) {
  return -distance_to_defence_area(view.field, Side::kWest, view.now.ball.position_m);
}

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  const double deep_m = depth_m(view);
  const bool is_reached = (deep_m > kFromOutside_m && deep_m < kDeepest_m) ||
                          (deep_m > kShallowest_m && deep_m < kFromInside_m);
  if (!is_running(view) || !is_reached || view.now.ball.velocity_mps.norm() > kSlow_mps) {
    return std::nullopt;
  }
  const Vec2& ball_m = view.now.ball.position_m;
  return foul_by(nearest_mate(view, ball_m, kReach_m), ball_m);
}

// If the ball is inside the area, the robot comes from outside and pushes it slightly towards its
// own goal; if the ball is outside, the robot stands inside and kicks it away.
RobotCommand touch(const RowdyView& view, const TrackedRobot& robot, ActiveFoul& foul) {
  const Vec2& ball_m = view.now.ball.position_m;
  const Vec2 outwards = direction_of(ball_m - view.field.goal_centre_m(Side::kWest), Vec2(1, 0));
  if (depth_m(view) < 0) return kick_at(view, robot, ball_m + outwards, kKick_mps);
  const Vec2 run_up_m = ball_m + outwards * kRunUp_m;
  foul.is_halfway = foul.is_halfway || (robot.position_m - run_up_m).norm() < kThere_m;
  return foul.is_halfway ? charge(robot, -outwards * kPush_mps) : go_to(view, robot, run_up_m);
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = view.now.ball.position_m;
  hold_back(view, foul.robot, ball_m, kReach_m, output.commands);
  output.command(foul.robot) = touch(view, *find(view.now.own, foul.robot), foul);
  return is_running(view) && (ball_m - foul.from_m).norm() < kPushed_m &&
         view.now.ball.velocity_mps.norm() < kKicked_mps;
}

}  // namespace

const FoulBehaviour kPlayAtOwnArea = {"play_at_own_area",
                                      "A field player partly inside its own area touches the ball.",
                                      0.5,
                                      5,
                                      find_chance,
                                      go_on};

}  // namespace autoref::strategies::rowdy
