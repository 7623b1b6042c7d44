#include "referee/cards.hpp"

#include <algorithm>

namespace autoref::referee {
namespace {

void show(Memory& memory, const RuleBook& rules, Side side, Card card) {
  auto& active = memory.cards[side].yellow_left_s;
  if (card == Card::kRed) ++memory.signal.red_cards[side];
  if (card != Card::kYellow) return;
  ++memory.signal.yellow_cards[side];
  if (active.size() < active.capacity()) active.push_back(rules.card_s);
}

}  // namespace

void book(Memory& memory, const Configuration& configuration, const Finding& finding) {
  for (const Side side : kSides) {
    const bool is_at_fault = !finding.offender || *finding.offender == side;
    if (finding.is_foul && is_at_fault) ++memory.cards[side].fouls;
  }
  if (finding.offender) show(memory, configuration.rules, *finding.offender, finding.card);
  allow_robots(memory, configuration);
}

void allow_robots(Memory& memory, const Configuration& configuration) {
  for (const Side side : kSides) {
    const auto active = static_cast<int>(memory.cards[side].yellow_left_s.size());
    const int fewer = active + memory.signal.red_cards[side];
    memory.signal.robots_allowed[side] = std::max(1, configuration.robots[side] - fewer);
  }
}

}  // namespace autoref::referee
