#include "soccer/parameters.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "soccer/rules/rule_book.hpp"

namespace autoref {
namespace {

struct Wheel {
  double radius_m = 0.02;
  int spokes = 6;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.radius_m, {"radius_m", positive(0.1), "from the axle to the carpet"});
    visitor(self.spokes, {"spokes", {2, 40}, "number of spokes"});
  }
};

struct Cart {
  bool has_bell = true;
  Wheel front;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.has_bell, {"has_bell", "whether it rings"});
    visitor(self.front, {"front", "its front wheel"});
  }
};

std::string refusal_of(const Cart& cart) {
  try {
    check_ranges(cart, "cart.");
  } catch (const OutOfRange& error) {
    return error.what();
  }
  return "";
}

TEST(Parameters, AreVisitedInOrderWithThePathsOfTheirBranches) {
  std::vector<std::string> paths;
  Cart cart;
  visit_all(cart, "",
            [&paths](auto& /*value*/, const Parameter& /*about*/, const std::string& path) {
              paths.push_back(path);
            });
  EXPECT_EQ(paths, (std::vector<std::string>{"has_bell", "front.radius_m", "front.spokes"}));
}

TEST(Parameters, AreRefusedOutsideTheirRange) {
  Cart cart;
  EXPECT_EQ(refusal_of(cart), "");
  cart.front.spokes = 41;
  EXPECT_EQ(refusal_of(cart), "cart.front.spokes is 41; it must be from 2 to 40");
  cart.front = {0};
  EXPECT_EQ(refusal_of(cart), "cart.front.radius_m is 0; it must be above 0 and at most 0.1");
  cart.front = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(refusal_of(cart), "cart.front.radius_m is nan; it must be above 0 and at most 0.1");
}

TEST(Range, ContainsItsEnds) {
  EXPECT_TRUE(from_to(-1, 2).contains(-1));
  EXPECT_TRUE(from_to(-1, 2).contains(2));
  EXPECT_FALSE(from_to(-1, 2).contains(2.001));
  EXPECT_FALSE(positive(2).contains(0));
  EXPECT_TRUE(up_to(2).contains(0));
}

TEST(UnitOfAName, IsItsEnding) {
  EXPECT_EQ(unit_of("shot_mps"), "m/s");
  EXPECT_EQ(unit_of("brake_radps2"), "rad/s^2");
  EXPECT_EQ(unit_of("pass_per_metre_per_s"), "1/s");
  EXPECT_EQ(unit_of("far_cost_per_m"), "1/m");
  EXPECT_EQ(unit_of("damping_nspm"), "N s/m");
  EXPECT_EQ(unit_of("spokes"), "");
}

TEST(RuleBooks, HaveNumbersWithinTheirRanges) {
  for (const std::string& name : rule_book_names()) {
    EXPECT_NO_THROW(check_ranges(*find_rule_book(name))) << name;
  }
}

}  // namespace
}  // namespace autoref
