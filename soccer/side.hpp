// The two sides of a game, their colours, and robot identifiers.
//
// Each side has a goal at its end of the field, a colour, robots and random streams. Which team
// plays on which side is set elsewhere (`match.a_plays`).
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string_view>

#include "soccer/named.hpp"

namespace autoref {

// West defends the goal at -x and wears yellow; east defends the goal at +x and wears blue. This
// holds in every half, regardless of the teams' ends on the field (referee_signal.hpp).
enum class Side : std::uint8_t { kWest, kEast };

inline constexpr std::array<Side, 2> kSides = {Side::kWest, Side::kEast};

constexpr Side opponent_of(Side side) { return side == Side::kWest ? Side::kEast : Side::kWest; }

// -1 for west, +1 for east: the sign of x at the side's own goal.
constexpr double goal_sign(Side side) { return side == Side::kWest ? -1.0 : 1.0; }

constexpr auto names_of(Side /*any*/) {
  return std::to_array<Named<Side>>({{Side::kWest, "west"}, {Side::kEast, "east"}});
}

// One value for each side.
template <typename T>
struct PerSide {
  std::array<T, 2> values{};
  constexpr T& operator[](Side side) { return values[static_cast<std::size_t>(side)]; }
  constexpr const T& operator[](Side side) const { return values[static_cast<std::size_t>(side)]; }
  bool operator==(const PerSide&) const = default;
};

// The league's patterns distinguish 16 robots per side, numbered 0 to 15.
inline constexpr int kMaxRobots = 16;

struct RobotId {
  Side side = Side::kWest;
  int number = 0;
  auto operator<=>(const RobotId&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

// "yellow" for west, "blue" for east.
constexpr std::string_view colour_of(Side side) { return side == Side::kWest ? "yellow" : "blue"; }

}  // namespace autoref
