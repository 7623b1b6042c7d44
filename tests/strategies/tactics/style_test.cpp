#include "strategies/tactics/style.hpp"

#include <gtest/gtest.h>

namespace autoref::strategies {
namespace {

TEST(Style, HasATunableForEveryNumber) {
  EXPECT_EQ(tunables().size(), sizeof(Style) / sizeof(double));
  for (const Tunable& one : tunables()) {
    for (const Tunable& other : tunables()) {
      EXPECT_EQ(one.number == other.number, one.about.name == other.about.name);
    }
  }
}

TEST(Style, HasDefaultsWithinTheirRanges) {
  for (const Parameter& parameter : parameters_of(Style{})) {
    EXPECT_GE(parameter.standard, parameter.least) << parameter.name;
    EXPECT_LE(parameter.standard, parameter.most) << parameter.name;
    EXPECT_FALSE(parameter.about.empty()) << parameter.name;
    EXPECT_FALSE(parameter.unit.empty()) << parameter.name;
  }
}

TEST(Style, ReplacesOnlyTheNumbersInParams) {
  Style own;
  own.width = 0.5;
  const Style style = tuned(own, {{"wall", 3}, {"line_m", 0.25}});
  EXPECT_EQ(style.wall, 3);
  EXPECT_EQ(style.line_m, 0.25);
  EXPECT_EQ(style.width, 0.5);
}

}  // namespace
}  // namespace autoref::strategies
