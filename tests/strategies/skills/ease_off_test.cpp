#include "strategies/skills/limits.hpp"

#include <gtest/gtest.h>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::strategies {
namespace {

// The velocity, along x, of a robot that wants to drive at 2 m/s towards an opponent at rest at
// that gap between the hulls.
double eased_mps(double gap_m, const Easing& easing) {
  const TrackedRobot robot{0, {0, 0}, {1, 0}, {0, 0}, 0};
  const TrackedRobots opponents = {{0, {2 * kRobotRadius_m + gap_m, 0}, {-1, 0}, {0, 0}, 0}};
  RobotCommand command;
  command.velocity_mps = {2, 0};
  ease_off(robot, opponents, easing, command);
  return command.velocity_mps.x();
}

TEST(EaseOff, LeavesADistantOpponentOutOfAccount) { EXPECT_DOUBLE_EQ(eased_mps(2, {}), 2); }

TEST(EaseOff, BrakesBeforeACrash) {
  EXPECT_LT(eased_mps(0.4, {}), 1.5);
  EXPECT_LT(eased_mps(0.05, {}), 0.6);
}

TEST(EaseOff, DoesNotPressAgainstAnOpponentInContact) {
  Easing easing;
  easing.contact_mps = 0;
  EXPECT_DOUBLE_EQ(eased_mps(0, easing), 0);
  EXPECT_GT(eased_mps(0, {}), 0.1);
}

}  // namespace
}  // namespace autoref::strategies
