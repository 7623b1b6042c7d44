#include "referee/machine/machine_figure.hpp"

#include <fmt/format.h>

#include "referee/machine/machine.hpp"

namespace autoref::referee {
namespace {

std::string condition_of(const Arrow& arrow) {
  if (arrow.guard.text.empty()) return std::string(name_of(arrow.event));
  return fmt::format("{}, {}", name_of(arrow.event), arrow.guard.text);
}

std::string from_of(const Arrow& arrow) {
  return arrow.from ? std::string(name_of(*arrow.from)) : "any";
}

std::string evidence_of(const Arrow& arrow) {
  if (arrow.deviations.empty()) return std::string(arrow.evidence);
  return fmt::format("{} ({})", arrow.evidence, arrow.deviations);
}

std::string diagram() {
  std::string text = "```mermaid\nstateDiagram-v2\n  [*] --> INIT\n";
  for (const Arrow& arrow : arrows_in_figure()) {
    text += fmt::format("  {} --> {}: {}\n", from_of(arrow), name_of(arrow.to), arrow.label);
  }
  return text + "```\n";
}

std::string table_of(std::span<const Arrow> arrows) {
  std::string text =
      "| arrow | from | when | to | what is done | evidence |\n|---|---|---|---|---|---|\n";
  for (const Arrow& arrow : arrows) {
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} |\n", arrow.label, from_of(arrow),
                    condition_of(arrow), name_of(arrow.to), arrow.action.text, evidence_of(arrow));
  }
  return text;
}

}  // namespace

std::string machine_figure() {
  return fmt::format(
      "{}\n{}\nOutside the figure, the game's time:\n\n{}\nBeyond the paper, under other rule "
      "books:\n\n{}\nCards, timeouts and knockout games, tried before all others:\n\n{}",
      diagram(), table_of(arrows_in_figure()), table_of(arrows_outside_figure()),
      table_of(arrows_beyond_paper()), table_of(arrows_of_administration()));
}

}  // namespace autoref::referee
