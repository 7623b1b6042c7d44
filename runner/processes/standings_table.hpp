// What a terminal shows of a run: a bar and the table so far, drawn over by the next.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace autoref::runner {

struct Screen {
  int rows = 24;
  int columns = 80;
};

// Of the terminal that the stream writes to; the usual size where it does not tell.
Screen screen_of(std::FILE* stream);

// "[######......] " for `done` of `total`.
std::string bar_text(int done, int total);

// Makes the line that the cursor is in, and all below it, empty.
inline constexpr std::string_view kClearTable = "\r\033[J";

// Draws `bar` and below it `table`, whose lines may be none, where the cursor is; leaves the cursor
// in the bar's line, for kClearTable or the next view. What does not fit the screen is cut off.
std::string standings_table(std::string_view bar, std::string_view table, const Screen& screen);

}  // namespace autoref::runner
