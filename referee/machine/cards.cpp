#include "referee/machine/cards.hpp"

#include <fmt/format.h>

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

std::string offence_text(const Finding& finding, const RuleBook& rules) {
  switch (finding.event) {
    case Event::kMultipleFouls:
    case Event::kMultipleCards:
      return fmt::format("{} foul (every {} brings a card)",
                         ordinal(static_cast<int>(finding.value)), ordinal(rules.fouls_per_card));
    case Event::kDefenderInDefenseAreaPartially:
      return "a defender played the ball partly inside its own area";
    case Event::kDefenderTooCloseToKickPoint:
      return "too near to the ball at two restarts in a row";
    default: {
      std::string name(name_of(finding.event));
      std::replace(name.begin(), name.end(), '_', ' ');
      return name;
    }
  }
}

}  // namespace

std::string card_reason(const PerSide<CardBook>& before, const Finding& finding, Card shown,
                        const RuleBook& rules) {
  std::string text = offence_text(finding, rules);
  if (shown == Card::kRed && rules.yellows_per_red > 0) {
    const CardBook& cards = before[finding.offender.value_or(Side::kWest)];
    text += fmt::format("; red because it would be the {} active yellow card",
                        ordinal(static_cast<int>(cards.yellow_ends_s.size()) + 1));
  }
  return text;
}

Card next_card(const CardBook& cards, const RuleBook& rules) {
  const auto active = static_cast<int>(cards.yellow_ends_s.size());
  const bool is_last_straw = rules.yellows_per_red > 0 && active + 1 >= rules.yellows_per_red;
  return is_last_straw ? Card::kRed : Card::kYellow;
}

void count_foul(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  for (const Side side : kSides) {
    if (!concerns(finding, side)) continue;
    if (finding.is_foul) ++state.cards[side].fouls;
    if (entry_of(finding.event).is_non_stopping) state.cards[side].fouled_s = input.time_s();
    if (finding.event == Event::kTooManyRobots) state.cards[side].too_many_called = true;
  }
}

void note_robots_allowed(RefereeState& state, const RefereeInput& input,
                         const PerSide<int>& before) {
  for (const Side side : kSides) {
    if (state.signal.robots_allowed[side] == before[side]) continue;
    state.cards[side].fewer_since_s = input.time_s();
    state.cards[side].too_many_called = false;
  }
}

void book(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  const PerSide<int> before = state.signal.robots_allowed;
  const bool gives_card =
      finding.card != Card::kNone && input.configuration.rules.has(RuleId::kCards);
  count_foul(state, input, finding);
  for (const Side side : kSides) {
    if (gives_card && concerns(finding, side)) show(state, input, side, finding.card);
  }
  allow_robots(state, input.configuration);
  note_robots_allowed(state, input, before);
}

void take_card_off(RefereeState& state, const Configuration& configuration,
                   const Finding& finding) {
  for (const Side side : kSides) {
    auto& ends_s = state.cards[side].yellow_ends_s;
    // All yellow cards have the same duration, so the first one in the list is the first to end.
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
