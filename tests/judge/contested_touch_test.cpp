#include "judge/evaluate_calls.hpp"

#include <gtest/gtest.h>

#include <array>

namespace autoref::judge {
namespace {

std::array<sim::Touch, 1> touch_by(Side side) {
  sim::Touch touch;
  touch.robot = {side, 3};
  return {touch};
}

bool is_contested(double west_s, double east_s, double exit_s) {
  SideTouches touches;
  touches.see(touch_by(Side::kWest), west_s);
  touches.see(touch_by(Side::kEast), east_s);
  return touches.is_contested(exit_s);
}

TEST(SideTouches, AreContestedIfBothSidesTouchWithinATenthOfASecondBeforeTheExit) {
  EXPECT_TRUE(is_contested(9.91, 9.99, 10));
  EXPECT_TRUE(is_contested(9.99, 9.91, 10));
  EXPECT_FALSE(is_contested(9.89, 9.99, 10));
  EXPECT_FALSE(is_contested(9.99, 9.89, 10));
}

TEST(SideTouches, AreNotContestedByOneSideAlone) {
  SideTouches touches;
  touches.see(touch_by(Side::kWest), 9.99);
  EXPECT_FALSE(touches.is_contested(10));
}

ground_truth::TrueEvent exit_event(std::string_view name, double time_s) {
  ground_truth::TrueEvent event;
  event.name = name;
  event.time_s = time_s;
  return event;
}

TEST(ExitTime, IsThatOfTheLatestTrueExit) {
  EXPECT_EQ(exit_time_s({exit_event("goal_kick", 9.2), exit_event("throw_in", 9.9),
                         exit_event("goal", 9.95)},
                        10),
            9.9);
}

TEST(ExitTime, IsThatOfTheCallIfNoExitIsNear) {
  EXPECT_EQ(exit_time_s({exit_event("throw_in", 8.9)}, 10), 10);
  EXPECT_EQ(exit_time_s({exit_event("bot_crash_unique", 9.9)}, 10), 10);
}

}  // namespace
}  // namespace autoref::judge
