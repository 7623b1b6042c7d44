// The machine's figure in referee/README.md, printed from the table.
#pragma once

#include <string>

namespace autoref::referee {

// A Mermaid state diagram of the transitions in the figure, followed by Markdown tables of all
// transitions. Ends with a newline.
std::string machine_figure();

// A Markdown table of calls and cards, with the league's names and the consequences. Ends with a
// newline.
std::string event_figure();

}  // namespace autoref::referee
