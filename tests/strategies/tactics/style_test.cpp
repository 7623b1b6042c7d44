#include "strategies/tactics/style.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "strategies/strategy.hpp"

namespace autoref::strategies {
namespace {

Tunable tunable_named(const std::string& name, const Style& style) {
  const std::vector<Tunable> all = tunables_of(style);
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Tunable& its) { return its.name == name; });
  if (found == all.end()) throw std::out_of_range("the style has no number " + name);
  return *found;
}

TEST(Tunables, TakeTheirDefaultsFromTheStyle) {
  Style own;
  own.line_m = 0.25;
  own.large_team = true;
  EXPECT_EQ(tunable_named("line_m", own).standard, 0.25);
  EXPECT_EQ(tunable_named("large_team", own).standard, 1);
}

TEST(Tunables, AreFlagsIfTheyAreYesOrNo) {
  EXPECT_TRUE(tunable_named("large_team", {}).is_flag);
  EXPECT_FALSE(tunable_named("pass_risk", {}).is_flag);
}

TEST(Style, ReplacesOnlyTheNumbersInParams) {
  Style own;
  own.width = 0.5;
  const Style style = tuned(own, {{"wall", 3}, {"line_m", 0.25}, {"around_boxes", 0}});
  EXPECT_EQ(style.wall, 3);
  EXPECT_EQ(style.line_m, 0.25);
  EXPECT_FALSE(style.around_boxes);
  EXPECT_EQ(style.width, 0.5);
  EXPECT_TRUE(style.penalty_on_line);
}

}  // namespace
}  // namespace autoref::strategies
