#include "logs/recorded_teams.hpp"

#include <gtest/gtest.h>

namespace autoref::logs {
namespace {

GoalDuty duty_of(int announced, int other, int nobody) {
  GoalDuty duty;
  duty.all = announced + other + nobody;
  duty.nearest[1] = announced;
  duty.nearest[7] = other;
  duty.nearest[3] = nobody;
  return duty;
}

TEST(ActualKeeper, IsTheAnnouncedOneIfItKeepsTheGoal) {
  EXPECT_FALSE(actual_keeper(duty_of(600, 400, 0), 1));
  EXPECT_FALSE(actual_keeper(duty_of(100, 900, 0), 1)) << "it may come out for a while";
}

TEST(ActualKeeper, IsAnotherThatKeepsTheGoalMostOfTheTime) {
  EXPECT_EQ(actual_keeper(duty_of(10, 900, 90), 1), 7);
}

TEST(ActualKeeper, IsUnknownIfTwoOthersTakeTurns) {
  EXPECT_EQ(actual_keeper(duty_of(0, 560, 440), 1), -1);
}

TEST(ActualKeeper, IsNotJudgedByAFewFrames) { EXPECT_FALSE(actual_keeper(duty_of(0, 99, 0), 1)); }

TEST(ActualKeeper, MayBeAnnouncedOutsideTheLeaguesRange) {
  EXPECT_EQ(actual_keeper(duty_of(0, 900, 0), 99), 7);
}

}  // namespace
}  // namespace autoref::logs
