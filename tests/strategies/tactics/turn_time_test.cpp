#include "strategies/tactics/kick_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/units.hpp"
#include "strategies/skills/strike.hpp"

namespace autoref::strategies {
namespace {

double chance(double turn_rad, double spare_s, double free_rad = 0) {
  Style style;
  style.ball_turn_radps = 5;
  style.late_spread_s = 0.1;
  return chance_to_turn(style, {Vec2(0, 1), free_rad, spare_s},
                        to_world(heading_of(turn_rad), Vec2(0, 1)));
}

TEST(TurnTime, FacingItsAimARobotIsInTime) { EXPECT_GT(chance(0, 0.5), 0.99); }

// 1.5 rad at 5 rad/s take 0.3 s, and the start 0.1 s.
TEST(TurnTime, IsEvenIfTheTurnTakesAllTheTimeThatIsLeft) {
  EXPECT_NEAR(chance(1.5, 0.4), 0.5, 1e-9);
  EXPECT_NEAR(chance(-1.5, 0.4), 0.5, 1e-9);
}

TEST(TurnTime, IsALogisticFunctionOfTheTimeLeft) {
  // 1 / (1 + e) and its complement
  EXPECT_NEAR(chance(1.5, 0.3), 0.268941, 1e-6);
  EXPECT_NEAR(chance(1.5, 0.5), 0.731059, 1e-6);
}

TEST(TurnTime, NeedsNoneWithinTheHeadingsFromWhichItKicksAtOnce) {
  EXPECT_NEAR(chance(1.5, 0.2, 1.0), chance(0.5, 0.2), 1e-9);
  EXPECT_NEAR(chance(0.9, 0.2, 1.0), chance(0, 0.2), 1e-9);
}

TEST(TurnTime, TheWidestFirstTouchIsTheAngleOfItsCosine) {
  EXPECT_NEAR(std::cos(kWideFirstTouch_rad), kWideFirstTouch, 1e-9);
}

}  // namespace
}  // namespace autoref::strategies
