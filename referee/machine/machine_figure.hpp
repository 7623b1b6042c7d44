// The machine's figure, printed from its table: what referee/README.md shows.
#pragma once

#include <string>

namespace autoref::referee {

// A Mermaid state diagram of the arrows in the figure, and a Markdown table of all arrows, those of
// the game's time apart. Ends with a newline.
std::string machine_figure();

}  // namespace autoref::referee
