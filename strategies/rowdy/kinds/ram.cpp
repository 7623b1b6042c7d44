#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kNearest_m = 600_mm;  // minimum distance between the centres, to accelerate
constexpr double kFarthest_m = 1400_mm;
constexpr double kOffBall_m = 500_mm;  // robots closer to the ball are not used
constexpr double kSpeed_mps = 3.0;
constexpr double kMet_m = 2 * kRobotRadius_m + 5_mm;

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_running(view)) return std::nullopt;
  for (const TrackedRobot& mate : view.now.own) {
    const bool is_free = mate.number != view.keeper &&
                         (mate.position_m - view.now.ball.position_m).norm() > kOffBall_m;
    if (!is_free) continue;
    const TrackedRobot* victim = nearest_opponent(view, mate.position_m, kFarthest_m);
    if (victim == nullptr || (victim->position_m - mate.position_m).norm() < kNearest_m) continue;
    return foul_against(*victim, mate);
  }
  return std::nullopt;
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const TrackedRobot* victim = victim_of(foul, view);
  if (victim == nullptr) return false;
  const TrackedRobot& robot = *find(view.now.own, foul.robot);
  output.command(foul.robot) = charge_at(robot, victim->position_m, kSpeed_mps);
  return (victim->position_m - robot.position_m).norm() > kMet_m;
}

}  // namespace

const FoulBehaviour kRam = {"ram", "Runs into an opponent at full speed.", 0.05, 2, find_chance,
                            go_on};

}  // namespace autoref::strategies::rowdy
