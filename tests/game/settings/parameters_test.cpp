// Every struct of parameters lists all of its members, and its defaults are allowed.
#include "soccer/parameters.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>

#include "game/loop/start_scene.hpp"
#include "referee/referee_configuration.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "strategies/basic/roles.hpp"
#include "strategies/tactics/style.hpp"

namespace autoref::game {
namespace {

// Converts to whatever a member is.
struct AnyMember {
  template <typename Member>
  operator Member() const;  // NOLINT(google-explicit-constructor): that is its purpose
};

template <typename Of, std::size_t... kIndices>
constexpr bool has_members(std::index_sequence<kIndices...> /*count*/) {
  return requires { Of{(static_cast<void>(kIndices), AnyMember{})...}; };
}

// The number of members of an aggregate: how many values its braces take. It is found by bisection,
// at least kLow and below kHigh.
template <typename Of, std::size_t kLow = 0, std::size_t kHigh = sizeof(Of) + 1>
constexpr std::size_t member_count() {
  constexpr std::size_t kMiddle = (kLow + kHigh) / 2;
  if constexpr (kLow + 1 == kHigh) {
    return kLow;
  } else if constexpr (has_members<Of>(std::make_index_sequence<kMiddle>{})) {
    return member_count<Of, kMiddle, kHigh>();
  } else {
    return member_count<Of, kLow, kMiddle>();
  }
}

template <typename Of>
std::size_t listed_count() {
  std::size_t count = 0;
  Of of;
  Of::visit(of, [&count](const auto& /*value*/, const Parameter& /*about*/) { ++count; });
  return count;
}

template <typename Of>
class StructOfParameters : public testing::Test {};

using Structs =
    testing::Types<DefenceArea, Field, referee::Match, sim::BallParameters, sim::ContactParameters,
                   sim::RobotParameters, sim::KickerParameters, sim::DribblerParameters,
                   sim::PlacementParameters, sim::VisionParameters, sim::RadioParameters,
                   sim::LineUpParameters, sim::Configuration, SceneWeights, strategies::Style,
                   strategies::basic::Style>;
TYPED_TEST_SUITE(StructOfParameters, Structs);

TYPED_TEST(StructOfParameters, ListsAllOfItsMembers) {
  EXPECT_EQ(listed_count<TypeParam>(), member_count<TypeParam>());
}

TYPED_TEST(StructOfParameters, HasDefaultsWithinTheirRanges) {
  EXPECT_NO_THROW(check_ranges(TypeParam{}));
}

}  // namespace
}  // namespace autoref::game
