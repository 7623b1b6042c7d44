#include "strategies/rowdy/foul_behaviours.hpp"

#include <algorithm>

namespace autoref::strategies::rowdy {
namespace {

constexpr double kShortest_m = 300_mm;
constexpr double kLongest_m = 1500_mm;
constexpr double kSpeed_mps = 0.8;
constexpr double kFaster_mps =
    0.1;  // added to the robot's current speed, so that it does not lose the ball
constexpr double kFromLines_m = 200_mm;
constexpr double kLost_m = 160_mm;  // distance from the robot's centre to a ball that it has lost
constexpr double kMates_m = 600_mm;

bool has_room(const RowdyView& view, const TrackedRobot& robot) {
  const Vec2 end_m = robot.position_m + robot.heading * (kLongest_m + kFromLines_m);
  return is_on_field(view.field, end_m);
}

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_running(view)) return std::nullopt;
  const Vec2& ball_m = view.now.ball.position_m;
  const TrackedRobot* mate = nearest_mate(view, ball_m, kLost_m);
  if (mate == nullptr || !has_ball(*mate, view.now.ball) || !has_room(view, *mate)) {
    return std::nullopt;
  }
  return foul_by(mate, ball_m);
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const TrackedRobot& robot = *find(view.now.own, foul.robot);
  const Vec2& ball_m = view.now.ball.position_m;
  const double now_mps = std::max(0.0, robot.velocity_mps.dot(robot.heading));
  RobotCommand& command = output.command(foul.robot);
  command = charge(robot, robot.heading * std::min(kSpeed_mps, now_mps + kFaster_mps));
  command.dribble = true;
  hold_back(view, foul.robot, ball_m, kMates_m, output.commands);
  const double far_m = kShortest_m + (kLongest_m - kShortest_m) * foul.amount;
  return is_running(view) && (ball_m - robot.position_m).norm() < kLost_m &&
         (ball_m - foul.from_m).norm() < far_m;
}

}  // namespace

const FoulBehaviour kLongDribble = {
    "long_dribble", "Dribbles the ball 0.3 to 1.5 m.", 0.15, 6, find_chance, go_on};

}  // namespace autoref::strategies::rowdy
