#include "referee/machine/machine_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "referee/machine/machine.hpp"
#include "referee/machine/machine_figure.hpp"

namespace autoref::referee {
namespace {

constexpr std::string_view kGraphHead =
    "digraph machine {\n"
    "  rankdir=TB; nodesep=0.9; ranksep=0.55; bgcolor=white;\n"
    "  node [shape=ellipse, fontname=\"Helvetica\", fontsize=13, style=filled, "
    "fillcolor=\"#e6eef7\"];\n"
    "  edge [fontname=\"Helvetica\", fontsize=10];\n"
    "  begin [shape=point, width=0.12];\n"
    "  begin -> INIT;\n";

struct MachineEdge {
  const Transition* first = nullptr;
  std::vector<std::string> conditions;

  bool has(const Transition& other) const {
    return first->from == other.from && first->to == other.to &&
           first->action.text == other.action.text;
  }
};

std::vector<MachineEdge> edges_of(std::span<const Transition> transitions) {
  std::vector<MachineEdge> edges;
  for (const Transition& transition : transitions) {
    auto edge = std::find_if(edges.begin(), edges.end(),
                             [&](const MachineEdge& one) { return one.has(transition); });
    if (edge == edges.end()) edge = edges.insert(edge, MachineEdge{&transition, {}});
    edge->conditions.push_back(condition_of(transition));
  }
  return edges;
}

// A line of text in a label, which is HTML.
std::string label_row(std::string_view text) {
  std::string row = "<tr><td>";
  for (const char c : text) {
    if (c == '&') {
      row += "&amp;";
    } else if (c == '<') {
      row += "&lt;";
    } else {
      row += c;
    }
  }
  return row + "</td></tr>";
}

// One line for each assignment, which are separated by "; ".
std::string action_rows(std::string_view text) {
  constexpr std::string_view kBetween = "; ";
  std::string rows;
  while (true) {
    const std::size_t end = text.find(kBetween);
    rows += label_row(text.substr(0, end));
    if (end == std::string_view::npos) return rows;
    text.remove_prefix(end + kBetween.size());
  }
}

std::string edge_label(const MachineEdge& edge) {
  std::string label = "<table border=\"0\" cellspacing=\"0\" cellpadding=\"1\">";
  for (const std::string& condition : edge.conditions) label += label_row(condition);
  return label + "<hr/>" + action_rows(edge.first->action.text) + "</table>";
}

}  // namespace

std::string machine_graph() {
  std::string text(kGraphHead);
  for (const MachineEdge& edge : edges_of(transitions_in_figure())) {
    text += fmt::format("  {} -> {} [label=<{}>];\n", from_of(*edge.first), to_of(*edge.first),
                        edge_label(edge));
  }
  return text + "}\n";
}

}  // namespace autoref::referee
