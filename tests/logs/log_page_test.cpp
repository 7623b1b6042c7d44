#include "logs/log_page.hpp"

#include <gtest/gtest.h>

namespace autoref::logs {
namespace {

Call shown_call_at(double time_s, std::string_view event, Side side) {
  return {time_s, time_s + 1, {CommandKind::kDirectFree, opponent_of(side)}, event, side};
}

TEST(ComparedCalls, SayWhatEachRefereeDid) {
  Agreement agreement;
  agreement.pairs = {
      {shown_call_at(5, "", Side::kWest), shown_call_at(5.1, "throw_in", Side::kWest)},
      {shown_call_at(9, "", Side::kEast), std::nullopt},
      {std::nullopt, shown_call_at(12, "goal_kick", Side::kEast)},
      {std::nullopt, shown_call_at(40, "goal", Side::kEast)}};
  const std::vector<view::ComparedCall> expected = {
      {5, "DIRECT_FREE_BLUE", "throw_in (yellow)", "", 5.1},
      {9, "DIRECT_FREE_YELLOW", "", "AutoRef: goal_kick (blue) at 12.00 s", std::nullopt},
      {12, "", "goal_kick (blue)", "recorded: DIRECT_FREE_YELLOW at 9.00 s", 12},
      {40, "", "goal (blue)", "recorded: nothing", 40}};
  EXPECT_EQ(compared_calls(agreement), expected);
}

TEST(MomentIn, IsAnAddress) { EXPECT_EQ(moment_in("a/both.html", 83.2), "a/both.html#t=83.20"); }

}  // namespace
}  // namespace autoref::logs
