// Messages to a live page (page.hpp), as JSON text.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "view/game_recording.hpp"
#include "view/page.hpp"

namespace autoref::view {

// The maximum amount of a game that a live page keeps; the oldest entries are dropped. These limits
// are enough for at least the last 7 hours of a game, which has about 640 signals, 3600 clock
// marks, 310 decisions, 800 chains and up to 500 shots per hour.
struct LiveLimits {
  std::size_t signals = 5'000;
  std::size_t clock_marks = 40'000;
  std::size_t decisions = 4'000;
  std::size_t chains = 6'000;
  std::size_t shots = 4'000;
};

// A message, and the number of frames or of entries of one list in it.
struct CountedMessage {
  std::string text;
  std::size_t entries = 0;
};

// The first message: teams, field, facts and LiveLimits, as on the page of a recorded game. A page
// that reconnects keeps what it has received if `id` is the same; otherwise it starts over.
std::string start_message(const PageContent& content, std::string_view id);

// A part of the game: frames, signals, clock, decisions, chains and shots. A part may contain any
// of these.
std::string part_message(const GameRecording& part);

// The part without its frames, as one message each for the signals, the clock, the decisions, the
// chains and the shots.
std::array<CountedMessage, 5> call_messages(const GameRecording& part);

// A message that says that the page has now received everything up to the present.
std::string present_message();

// A message that says that the game or run is over; `text` is a sentence that says so.
std::string over_message(std::string_view text);

// The first message to the page of a run. A page that has another title reloads.
std::string run_start_message(std::string_view title);

// How many games of a run are done, as numbers and as a sentence, with an optional remark below the
// sentence.
struct RunProgress {
  int done = 0;
  int total = 0;
  std::string text;
  std::string remark = {};
};
std::string progress_message(const RunProgress& progress);

// A message with the results so far, as HTML.
std::string results_message(std::string_view html);

// A game of a run.
struct ListedGame {
  std::string id;
  std::string text;       // "cobalt 3:1 zone"
  bool has_page = false;  // whether the server has a page with this id
};

// A message with the games being played and the latest games to end, the newest first.
std::string games_message(const std::vector<ListedGame>& running,
                          const std::vector<ListedGame>& ended);

}  // namespace autoref::view
