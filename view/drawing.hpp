// Draws an instant of a game, or the paths over a few seconds, as a figure for documents.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::view {

struct DrawnGame {
  Field field;
  PerSide<std::string> names;           // names of the teams; empty if unknown
  std::optional<RefereeSignal> signal;  // signal at the last frame; nullopt if the log has none
  std::vector<Frame> frames;            // frames in order of time, at least one
};

// SVG of the field with robots and ball as in the last frame. With several frames, the drawing also
// shows the paths up to that frame, which fade with age and start with a ring.
std::string drawing_of(const DrawnGame& game);

}  // namespace autoref::view
