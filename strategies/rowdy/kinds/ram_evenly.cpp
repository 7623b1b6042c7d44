#include "strategies/rowdy/foul_behaviours.hpp"

#include <algorithm>

namespace autoref::strategies::rowdy {
namespace {

constexpr double kNearest_m = 600_mm;  // minimum distance between the centres
constexpr double kFarthest_m = 1600_mm;
constexpr double kComes_mps = 0.8;  // speed of the opponent towards the robot
constexpr double kStraight = 0.95;  // fraction of the opponent's speed that is towards the robot
constexpr double kMet_m = 2 * kRobotRadius_m + 5_mm;

double closing_mps(const TrackedRobot& mover, const Vec2& point_m) {
  return mover.velocity_mps.dot(direction_of(point_m - mover.position_m, Vec2(0, 0)));
}

bool comes(const TrackedRobot& opponent, const TrackedRobot& mate) {
  const double distance_m = (opponent.position_m - mate.position_m).norm();
  const double towards_mps = closing_mps(opponent, mate.position_m);
  return distance_m > kNearest_m && distance_m < kFarthest_m && towards_mps > kComes_mps &&
         towards_mps > kStraight * opponent.velocity_mps.norm();
}

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_running(view)) return std::nullopt;
  for (const TrackedRobot& mate : view.now.own) {
    if (mate.number == view.keeper) continue;
    for (const TrackedRobot& opponent : view.now.opponents) {
      if (!comes(opponent, mate)) continue;
      return foul_against(opponent, mate);
    }
  }
  return std::nullopt;
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const TrackedRobot* opponent = victim_of(foul, view);
  if (opponent == nullptr) return false;
  const TrackedRobot& robot = *find(view.now.own, foul.robot);
  const double speed_mps = std::max(0.0, closing_mps(*opponent, robot.position_m));
  output.command(foul.robot) = charge_at(robot, opponent->position_m, speed_mps);
  return (opponent->position_m - robot.position_m).norm() > kMet_m;
}

}  // namespace

const FoulBehaviour kRamEvenly = {
    "ram_evenly", "Collides head-on with an opponent at the opponent's speed.",
    0.05,         2,
    find_chance,  go_on};

}  // namespace autoref::strategies::rowdy
