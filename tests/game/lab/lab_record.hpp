// Helpers to search the recording of a lab scene.
#pragma once

#include <functional>
#include <stdexcept>

#include "game/lab/lab.hpp"

namespace autoref::game::lab_measures {

using sim::BallState;
using sim::RobotState;
using sim::WorldState;

inline constexpr double kFrame_s = 1.0 / 60;

inline const RobotState& west(const WorldState& state, std::size_t number = 0) {
  return state.robots[Side::kWest][number];
}

inline const RobotState& east(const WorldState& state) { return state.robots[Side::kEast][0]; }

// The first frame, from the second on, for which `holds` returns true.
inline std::size_t first_frame(
    const LabRecord& record,
    const std::function<bool(const WorldState&, const WorldState&)>& holds) {
  for (std::size_t f = 1; f < record.states.size(); ++f) {
    if (holds(record.states[f - 1], record.states[f])) return f;
  }
  throw std::runtime_error("what was to be measured never happened");
}

}  // namespace autoref::game::lab_measures
