// A moment of a game, or the ways of some seconds, as a frame for documents.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

struct DrawnGame {
  Field field;
  PerSide<std::string> names;           // of the teams; empty where they are not known
  std::optional<RefereeSignal> signal;  // at the last frame; none where the log has none
  std::vector<Frame> frames;            // by time, at least one
};

// The field, with robots and ball as the last frame shows them. Where there are several, also
// the ways until then, the older the fainter, and rings where they began. SVG.
std::string drawing_of(const DrawnGame& game);

}  // namespace autoref::runner
