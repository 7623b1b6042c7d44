// Draws the state machine like the paper's Fig. 3, from the transition table.
#pragma once

#include <string>

namespace autoref::referee {

// The transitions in the figure as a graph in Graphviz's language, for `dot -Tsvg`. As in the
// paper, each edge is labelled with its conditions above a line and its assignments below it.
// Transitions that differ only in their condition share an edge; any one of its conditions
// suffices. Ends with a newline.
std::string machine_graph();

}  // namespace autoref::referee
