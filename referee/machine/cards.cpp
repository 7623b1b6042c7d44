#include "referee/machine/cards.hpp"

#include <algorithm>

namespace autoref::referee {
namespace {

bool concerns(const Finding& finding, Side side) {
  return !finding.offender || *finding.offender == side;
}

void show(RefereeState& state, const RefereeInput& input, Side side, Card card) {
  const RuleBook& rules = input.configuration.rules;
  CardBook& cards = state.cards[side];
  const Card shown = card == Card::kYellow ? next_card(cards, rules) : card;
  if (shown == Card::kRed) {
    ++state.signal.red_cards[side];
    return;
  }
  ++state.signal.yellow_cards[side];
  if (cards.yellow_ends_s.size() == cards.yellow_ends_s.capacity()) return;
  cards.yellow_ends_s.push_back(state.play_clock.at_s(input.time_s()) + rules.card_s);
}

}  // namespace

Card next_card(const CardBook& cards, const RuleBook& rules) {
  const auto active = static_cast<int>(cards.yellow_ends_s.size());
  const bool is_last_straw = rules.yellows_per_red > 0 && active + 1 >= rules.yellows_per_red;
  return is_last_straw ? Card::kRed : Card::kYellow;
}

void book(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  const PerSide<int> before = state.signal.robots_allowed;
  const bool gives_card =
      finding.card != Card::kNone && input.configuration.rules.has(RuleId::kCards);
  for (const Side side : kSides) {
    if (!concerns(finding, side)) continue;
    if (finding.is_foul) ++state.cards[side].fouls;
    if (entry_of(finding.event).is_non_stopping) state.cards[side].fouled_s = input.time_s();
    if (finding.event == Event::kTooManyRobots) state.cards[side].too_many_called = true;
    if (gives_card) show(state, input, side, finding.card);
  }
  allow_robots(state, input.configuration);
  for (const Side side : kSides) {
    if (state.signal.robots_allowed[side] == before[side]) continue;
    state.cards[side].fewer_since_s = input.time_s();
    state.cards[side].too_many_called = false;
  }
}

void take_card_off(RefereeState& state, const Configuration& configuration,
                   const Finding& finding) {
  for (const Side side : kSides) {
    auto& ends_s = state.cards[side].yellow_ends_s;
    if (concerns(finding, side) && !ends_s.empty()) ends_s.erase(ends_s.begin());
  }
  allow_robots(state, configuration);
}

void allow_robots(RefereeState& state, const Configuration& configuration) {
  for (const Side side : kSides) {
    const auto active = static_cast<int>(state.cards[side].yellow_ends_s.size());
    const int fewer = active + state.signal.red_cards[side];
    state.signal.robots_allowed[side] = std::max(1, configuration.robots[side] - fewer);
  }
}

}  // namespace autoref::referee
