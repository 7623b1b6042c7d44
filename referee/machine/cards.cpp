#include "referee/machine/cards.hpp"

#include <algorithm>

namespace autoref::referee {
namespace {

bool concerns(const Finding& finding, Side side) {
  return !finding.offender || *finding.offender == side;
}

void show(Memory& memory, const Moment& moment, Side side, Card card) {
  const RuleBook& rules = moment.configuration.rules;
  CardBook& cards = memory.cards[side];
  const Card shown = card == Card::kYellow ? next_card(cards, rules) : card;
  if (shown == Card::kRed) {
    ++memory.signal.red_cards[side];
    return;
  }
  ++memory.signal.yellow_cards[side];
  if (cards.yellow_ends_s.size() == cards.yellow_ends_s.capacity()) return;
  cards.yellow_ends_s.push_back(memory.play_clock.at_s(moment.time_s()) + rules.card_s);
}

}  // namespace

Card next_card(const CardBook& cards, const RuleBook& rules) {
  const auto active = static_cast<int>(cards.yellow_ends_s.size());
  const bool is_last_straw = rules.yellows_per_red > 0 && active + 1 >= rules.yellows_per_red;
  return is_last_straw ? Card::kRed : Card::kYellow;
}

void book(Memory& memory, const Moment& moment, const Finding& finding) {
  const PerSide<int> before = memory.signal.robots_allowed;
  const bool gives_card =
      finding.card != Card::kNone && moment.configuration.rules.has(RuleId::kCards);
  for (const Side side : kSides) {
    if (!concerns(finding, side)) continue;
    if (finding.is_foul) {
      ++memory.cards[side].fouls;
      memory.cards[side].fouled_s = moment.time_s();
    }
    if (finding.event == Event::kTooManyRobots) memory.cards[side].too_many_called = true;
    if (gives_card) show(memory, moment, side, finding.card);
  }
  allow_robots(memory, moment.configuration);
  for (const Side side : kSides) {
    if (memory.signal.robots_allowed[side] == before[side]) continue;
    memory.cards[side].fewer_since_s = moment.time_s();
    memory.cards[side].too_many_called = false;
  }
}

void take_card_off(Memory& memory, const Configuration& configuration, const Finding& finding) {
  for (const Side side : kSides) {
    auto& ends_s = memory.cards[side].yellow_ends_s;
    if (concerns(finding, side) && !ends_s.empty()) ends_s.erase(ends_s.begin());
  }
  allow_robots(memory, configuration);
}

void allow_robots(Memory& memory, const Configuration& configuration) {
  for (const Side side : kSides) {
    const auto active = static_cast<int>(memory.cards[side].yellow_ends_s.size());
    const int fewer = active + memory.signal.red_cards[side];
    memory.signal.robots_allowed[side] = std::max(1, configuration.robots[side] - fewer);
  }
}

}  // namespace autoref::referee
