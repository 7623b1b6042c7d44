// Prints the figures and tables of referee/README.md from the transition table, and draws the
// figure in the style of the paper's Fig. 3.
#pragma once

#include <span>
#include <string>

#include "referee/machine/machine.hpp"

namespace autoref::referee {

// A Mermaid state diagram of the transitions in the figure, followed by Markdown tables of all
// transitions. Ends with a newline.
std::string machine_figure();

// The same diagram and table for the given transitions.
std::string machine_figure(std::span<const Transition> transitions);

// Parts of a transition as text: its condition ("ready, next is a preparation") and the names of
// its states.
std::string condition_of(const Transition& transition);
std::string from_of(const Transition& transition);
std::string to_of(const Transition& transition);

// The transitions in the figure as a graph in Graphviz's language, for `dot -Tsvg`. As in the
// paper, each edge is labelled with its conditions above a line and its assignments below it.
// Transitions that differ only in their conditions share an edge, and any one of these conditions
// suffices. Ends with a newline.
std::string machine_graph();

}  // namespace autoref::referee
