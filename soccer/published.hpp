// From the program's coordinates to those of the field.
//
// When teams change ends, nothing moves in the program: for the world, the referee and the teams,
// west wears yellow and defends the goal at -x in every half, which the field's symmetry permits.
// What is published (logs, event logs, pages) has the field's coordinates, with each team at its
// current end: the same, or rotated by 180 degrees.
#pragma once

#include <string_view>

#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref {

inline Vec2 published(const Vec2& position_m, bool blue_on_positive_half) {
  return blue_on_positive_half ? position_m : Vec2(Vec2(0, 0) - position_m);  // never -0
}

inline Frame published(const Frame& frame, bool blue_on_positive_half) {
  return blue_on_positive_half ? frame : rotated(frame);
}

inline OtherDetections published(const OtherDetections& others, bool blue_on_positive_half) {
  return blue_on_positive_half ? others : rotated(others);
}

// Sides are colours here and stay.
inline RefereeSignal published(RefereeSignal signal) {
  if (signal.placement)
    signal.placement->target_m =
        published(signal.placement->target_m, signal.blue_on_positive_half);
  return signal;
}

// The side whose colour has its goal at this end of the field: west is -x, east is +x.
constexpr Side side_at(Side end, bool blue_on_positive_half) {
  return blue_on_positive_half ? end : opponent_of(end);
}

// The end of the field that yellow defends, "west" or "east".
constexpr std::string_view end_of_yellow(bool blue_on_positive_half) {
  return name_of(side_at(Side::kWest, blue_on_positive_half));
}

}  // namespace autoref
