// Messages to a live page (page.hpp), as JSON text.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "runner/view/game_recording.hpp"
#include "runner/view/page.hpp"

namespace autoref::runner {

// How much of a game a live page keeps at most; it forgets the oldest. At least the last 7 hours of
// a game fit in: one has about 640 signals, 3600 marks of the clock and 310 decisions per hour.
struct LiveLimits {
  std::size_t signals = 5'000;
  std::size_t clock_marks = 40'000;
  std::size_t decisions = 4'000;
};

// A message, and how many frames, signals, marks of the clock or decisions it contains.
struct CountedMessage {
  std::string text;
  std::size_t entries = 0;
};

// The first message: teams, field, facts and LiveLimits, as on the page of a recorded game. A page
// that connects again keeps what it has received if `id` is the same; otherwise it starts over.
std::string start_message(const PageContent& content, std::string_view id);

// A part of the game: frames, signals, clock and decisions. Parts may contain any of these.
std::string part_message(const GameRecording& part);

// The same without the frames, as one message for the signals, one for the clock and one for the
// decisions.
std::array<CountedMessage, 3> call_messages(const GameRecording& part);

// The page has now got everything up to the present.
std::string present_message();

// What is shown is over; `text` is a sentence that says so.
std::string over_message(std::string_view text);

// The first message to a table page, the ids of games whose pages the server has (newest first),
// and the text to show.
std::string table_start_message();
std::string games_message(const std::vector<std::string>& ids);
std::string table_message(std::string_view text);

}  // namespace autoref::runner
