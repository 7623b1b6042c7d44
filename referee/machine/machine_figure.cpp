#include "referee/machine/machine_figure.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <string_view>
#include <vector>

#include "referee/machine/machine.hpp"

namespace autoref::referee {
namespace {

std::string label_of(const Transition& transition) {
  if (!transition.label.empty()) return std::string(transition.label);
  return transition.trigger.event ? std::string(name_of(*transition.trigger.event)) : "*the event*";
}

std::string evidence_of(const Transition& transition) {
  if (transition.deviations.empty()) return std::string(transition.evidence);
  return fmt::format("{} ({})", transition.evidence, transition.deviations);
}

std::string diagram(std::span<const Transition> transitions) {
  std::string text = "```mermaid\nstateDiagram-v2\n  [*] --> INIT\n";
  for (const Transition& transition : transitions) {
    text += fmt::format("  {} --> {}: {}\n", from_of(transition), to_of(transition),
                        transition.label.empty() ? transition.trigger.text : transition.label);
  }
  return text + "```\n";
}

std::string table_of(std::span<const Transition> transitions) {
  std::string text =
      "| transition | from | when | to | action | evidence |\n|---|---|---|---|---|---|\n";
  for (const Transition& transition : transitions) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", label_of(transition),
                        from_of(transition), condition_of(transition), to_of(transition),
                        transition.action.text, evidence_of(transition));
  }
  return text;
}

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

// One line of text in a label. Labels are HTML.
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

// One line for each assignment. In the transition's text, assignments are separated by "; ".
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

std::string condition_of(const Transition& transition) {
  const Trigger& trigger = transition.trigger;
  const std::string_view what = trigger.event ? name_of(*trigger.event) : trigger.text;
  return transition.guard.text.empty() ? std::string(what)
                                       : fmt::format("{}, {}", what, transition.guard.text);
}

std::string from_of(const Transition& transition) {
  return transition.from ? std::string(name_of(*transition.from)) : "any";
}

std::string to_of(const Transition& transition) {
  return transition.to ? std::string(name_of(*transition.to)) : "the same";
}

std::string machine_figure() {
  return fmt::format(
      "{}\n{}\nOutside the figure, the game's time:\n\n{}\nBeyond the paper, under other rule "
      "books:\n\n{}\nBall placement by the teams, tried before the figure:\n\n{}\nCards, timeouts "
      "and knockout games, tried before those above:\n\n{}\nGames that begin in the middle of a "
      "half "
      "(situations), tried before all others:\n\n{}",
      diagram(transitions_in_figure()), table_of(transitions_in_figure()),
      table_of(transitions_outside_figure()), table_of(transitions_beyond_paper()),
      table_of(transitions_of_placement()), table_of(transitions_of_administration()),
      table_of(transitions_midway()));
}

std::string machine_figure(std::span<const Transition> transitions) {
  return fmt::format("{}\n{}", diagram(transitions), table_of(transitions));
}

std::string machine_graph() {
  std::string text(kGraphHead);
  for (const MachineEdge& edge : edges_of(transitions_in_figure())) {
    text += fmt::format("  {} -> {} [label=<{}>];\n", from_of(*edge.first), to_of(*edge.first),
                        edge_label(edge));
  }
  return text + "}\n";
}

}  // namespace autoref::referee
