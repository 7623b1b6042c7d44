#include "strategies/skills/ease_off.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::strategies {
namespace {

// Robots this near to each other are in contact, or both with a ball between them.
constexpr double kContact_m = 35_mm;

}  // namespace

void ease_off(const TrackedRobot& robot, const TrackedRobots& opponents, const Easing& easing,
              RobotCommand& command) {
  Vec2 velocity_mps = to_world(command.velocity_mps, robot.heading);
  for (const TrackedRobot& opponent : opponents) {
    const Vec2 there = opponent.position_m - robot.position_m;
    const double gap_m = there.norm() - 2 * kRobotRadius_m;
    if (gap_m > easing.from_m) continue;
    const Vec2 direction = direction_of(there, Vec2(1, 0));
    const double most_mps =
        easing.gentle_mps + std::sqrt(2 * easing.braking_mps2 * std::max(0.0, gap_m));
    const double closing_mps = (velocity_mps - opponent.velocity_mps).dot(direction);
    if (closing_mps > most_mps) velocity_mps -= direction * (closing_mps - most_mps);
    if (gap_m > kContact_m) continue;
    const double pressing_mps = velocity_mps.dot(direction) - easing.contact_mps;
    if (pressing_mps > 0) velocity_mps -= direction * pressing_mps;
  }
  command.velocity_mps = to_local(velocity_mps, robot.heading);
}

}  // namespace autoref::strategies
