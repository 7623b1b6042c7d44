// A game as JSON, as the page's script reads it (runner/view/page/recording.js).
#pragma once

#include "runner/io/json.hpp"
#include "runner/view/page.hpp"

namespace autoref::runner {

// Everything but the packed frames (GameRecording::bytes()).
Json game_json(const PageContent& content);

// Adds what the recording contains: the number of frames, robots, signals, clock and decisions.
void fill_recording(const GameRecording& recording, Json& json);

}  // namespace autoref::runner
