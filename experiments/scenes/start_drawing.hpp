// Draws the start of a scene.
#pragma once

#include <string>

#include "game/loop/start_scene.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::experiments {

// SVG of the field with robots, ball and restart.
std::string drawing_of(const game::StartState& start, const Field& field,
                       const PerSide<std::string>& names);

}  // namespace autoref::experiments
