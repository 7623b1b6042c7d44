// The machine's figure, printed from its table: what referee/README.md shows.
#pragma once

#include <string>

namespace autoref::referee {

// A Mermaid state diagram of the transitions in the figure, and a Markdown table of all
// transitions, those of the game's time apart. Ends with a newline.
std::string machine_figure();

// A Markdown table of calls and cards: what the league calls them and what follows. It ends with a
// newline.
std::string event_figure();

}  // namespace autoref::referee
