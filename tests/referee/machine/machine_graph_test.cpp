#include "referee/machine/machine_figure.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "referee/machine/machine.hpp"
#include "tests/checkout.hpp"

namespace autoref::referee {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

// The text of the committed drawing, without its hyphens' escapes.
std::string figure3() {
  std::ifstream file(in_checkout("docs/figures/figure3.svg"));
  std::stringstream text;
  text << file.rdbuf();
  return std::regex_replace(std::regex_replace(text.str(), std::regex("&#45;"), "-"),
                            std::regex("&#39;"), "'");
}

TEST(MachineGraph, HasEveryTransitionOfTheFigure) {
  const std::string graph = machine_graph();
  for (const Transition& transition : transitions_in_figure()) {
    EXPECT_EQ(count(graph, "<td>" + condition_of(transition) + "</td>"), 1U) << transition.label;
    EXPECT_GE(count(graph, from_of(transition) + " -> " + to_of(transition) + " [label="), 1U);
  }
}

TEST(MachineGraph, JoinsTransitionsThatDifferOnlyInTheirCondition) {
  std::set<std::tuple<std::string, std::string, std::string_view>> edges;
  for (const Transition& transition : transitions_in_figure())
    edges.emplace(from_of(transition), to_of(transition), transition.action.text);
  EXPECT_EQ(count(machine_graph(), " -> "), edges.size() + 1);  // and that into INIT
}

TEST(MachineGraph, InTheDocumentationIsDrawnFromTheTable) {
  const std::string figure = figure3();
  for (const Transition& transition : transitions_in_figure()) {
    EXPECT_NE(figure.find(">" + condition_of(transition) + "<"), std::string::npos)
        << transition.label << " is not in docs/figures/figure3.svg; run scripts/paper-figures 3";
    const std::string_view text = transition.action.text;
    const std::string first(text.substr(0, text.find("; ")));
    EXPECT_NE(figure.find(">" + first + "<"), std::string::npos) << first;
  }
}

}  // namespace
}  // namespace autoref::referee
