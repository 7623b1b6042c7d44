#include "referee/machine/machine_figure.hpp"

#include <fmt/format.h>

#include "referee/machine/machine.hpp"

namespace autoref::referee {
namespace {

std::string condition_of(const Transition& transition) {
  if (transition.guard.text.empty()) return std::string(name_of(transition.event));
  return fmt::format("{}, {}", name_of(transition.event), transition.guard.text);
}

std::string from_of(const Transition& transition) {
  return transition.from ? std::string(name_of(*transition.from)) : "any";
}

std::string evidence_of(const Transition& transition) {
  if (transition.deviations.empty()) return std::string(transition.evidence);
  return fmt::format("{} ({})", transition.evidence, transition.deviations);
}

std::string diagram() {
  std::string text = "```mermaid\nstateDiagram-v2\n  [*] --> INIT\n";
  for (const Transition& transition : transitions_in_figure()) {
    text += fmt::format("  {} --> {}: {}\n", from_of(transition), name_of(transition.to),
                        transition.label);
  }
  return text + "```\n";
}

std::string table_of(std::span<const Transition> transitions) {
  std::string text =
      "| transition | from | when | to | what is done | evidence |\n|---|---|---|---|---|---|\n";
  for (const Transition& transition : transitions) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", transition.label, from_of(transition),
                        condition_of(transition), name_of(transition.to), transition.action.text,
                        evidence_of(transition));
  }
  return text;
}

}  // namespace

std::string machine_figure() {
  return fmt::format(
      "{}\n{}\nOutside the figure, the game's time:\n\n{}\nBeyond the paper, under other rule "
      "books:\n\n{}\nCards, timeouts and knockout games, tried before all others:\n\n{}",
      diagram(), table_of(transitions_in_figure()), table_of(transitions_outside_figure()),
      table_of(transitions_beyond_paper()), table_of(transitions_of_administration()));
}

}  // namespace autoref::referee
