// Messages to a live page (page.hpp), as JSON text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runner/view/game_recording.hpp"
#include "runner/view/page.hpp"

namespace autoref::runner {

// The first message: teams, field and facts, as on the page of a recorded game. A page that
// connects again keeps what it has received if `id` is the same; otherwise it starts over.
std::string start_message(const PageContent& content, std::string_view id);

// A part of the game: frames, signals, clock and decisions. Parts may contain any of these.
std::string part_message(const GameRecording& part);

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
