#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kNearest_m = 450_mm;  // minimum distance between the centres, to accelerate
constexpr double kReach_m = 800_mm;
constexpr double kStill_mps = 0.3;  // maximum speed of the opponent
// A pushed robot brakes harder than the pushing one can accelerate, so the push needs some initial
// speed, but less than would count as a crash.
constexpr double kSpeed_mps = 1.45;
constexpr double kFar_m = 350_mm;  // distance after which the push ends

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_running(view)) return std::nullopt;
  for (const TrackedRobot& mate : view.now.own) {
    const TrackedRobot* victim = nearest_opponent(view, mate.position_m, kReach_m);
    if (mate.number == view.keeper || victim == nullptr) continue;
    if (victim->velocity_mps.norm() > kStill_mps) continue;
    if ((victim->position_m - mate.position_m).norm() < kNearest_m) continue;
    return foul_against(*victim, mate);
  }
  return std::nullopt;
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const TrackedRobot* victim = victim_of(foul, view);
  if (victim == nullptr) return false;
  const TrackedRobot& robot = *find(view.now.own, foul.robot);
  output.command(foul.robot) = charge_at(robot, victim->position_m, kSpeed_mps);
  return (victim->position_m - foul.from_m).norm() < kFar_m;
}

}  // namespace

const FoulBehaviour kShove = {"shove", "Pushes an opponent back.", 0.08, 3, find_chance, go_on};

}  // namespace autoref::strategies::rowdy
