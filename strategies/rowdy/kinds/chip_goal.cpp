#include "strategies/rowdy/foul_behaviours.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::strategies::rowdy {
namespace {

constexpr double kNear_m = 500_mm;
constexpr double kNearest_m = 900_mm;  // minimum distance from the goal's centre to the ball
constexpr double kFarthest_m = 2600_mm;
constexpr double kLandsBefore_m = 300_mm;  // distance from the landing point to the goal line
constexpr double kGravity_mps2 = 9.81;
constexpr double kKicked_mps = 1.5;

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  const Vec2& ball_m = view.now.ball.position_m;
  const double to_goal_m = (view.field.goal_centre_m(Side::kEast) - ball_m).norm();
  if (!is_running(view) || to_goal_m < kNearest_m || to_goal_m > kFarthest_m) return std::nullopt;
  return foul_by(nearest_mate(view, ball_m, kNear_m), ball_m);
}

// A 45-degree chip at speed v has a range of v^2 / g.
bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2 goal_m = view.field.goal_centre_m(Side::kEast);
  const double range_m = (goal_m - view.now.ball.position_m).norm() - kLandsBefore_m;
  const double kick_mps = std::sqrt(kGravity_mps2 * std::max(0.1, range_m));
  RobotCommand& command = output.command(foul.robot);
  command = kick_at(view, *find(view.now.own, foul.robot), goal_m, kick_mps);
  command.chip = true;
  hold_back(view, foul.robot, view.now.ball.position_m, kNear_m, output.commands);
  return is_running(view) && view.now.ball.velocity_mps.norm() < kKicked_mps;
}

}  // namespace

const FoulBehaviour kChipGoal = {
    "chip_goal", "Chips at the goal so that the ball lands in front of it and bounces in.",
    0.3,         4,
    find_chance, go_on};

}  // namespace autoref::strategies::rowdy
