#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kReach_m = 2.5;     // largest distance from the goal's centre to the robot chosen
constexpr double kPlays_m = 600_mm;  // the robot goes for the ball if it is within this distance
constexpr double kKick_mps = 4.0;
constexpr double kKicked_mps = 2.0;

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_running(view) || view.now.ball.position_m.x() < 0) return std::nullopt;
  return foul_by(nearest_mate(view, view.field.goal_centre_m(Side::kEast), kReach_m),
                 view.now.ball.position_m);
}

// The robot waits in the area, in the ball's path to the goal, and plays the ball once it arrives.
bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const TrackedRobot& robot = *find(view.now.own, foul.robot);
  const Vec2& ball_m = view.now.ball.position_m;
  const Vec2 goal_m = view.field.goal_centre_m(Side::kEast);
  const Vec2 direction = direction_of(ball_m - goal_m, Vec2(-1, 0));
  const bool is_near = (ball_m - robot.position_m).norm() < kPlays_m;
  const bool is_inside = distance_to_defence_area(view.field, Side::kEast, ball_m) < 0;
  RobotCommand& command = output.command(foul.robot);
  command = is_near && is_inside
                ? kick_at(view, robot, goal_m, kKick_mps)
                : go_to(view, robot, goal_m + direction * view.field.defence_area.depth_m / 2);
  command.dribble = true;
  return is_running(view) && (!is_near || view.now.ball.velocity_mps.norm() < kKicked_mps);
}

}  // namespace

const FoulBehaviour kAttackInArea = {
    "attack_in_area", "Plays the ball inside the opponents' area.", 0.1, 5, find_chance, go_on};

}  // namespace autoref::strategies::rowdy
