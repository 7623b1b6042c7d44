// A game as JSON, as the page's script reads it (view/page/recording.js).
#pragma once

#include "io/json.hpp"
#include "view/page.hpp"

namespace autoref::view {

// Everything but the packed frames (GameRecording::bytes()).
io::Json game_json(const PageContent& content);

// Adds what the recording contains: the number of frames, robots, signals, clock and decisions.
void fill_recording(const GameRecording& recording, io::Json& json);

}  // namespace autoref::view
