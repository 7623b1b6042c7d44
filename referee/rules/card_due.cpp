#include "referee/rules/card_due.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "referee/machine/cards.hpp"

namespace autoref::referee {
namespace {

// The side concerned; none where both are.
std::optional<Side> one_of(const PerSide<bool>& sides) {
  if (sides[Side::kWest] && sides[Side::kEast]) return std::nullopt;
  return sides[Side::kWest] ? Side::kWest : Side::kEast;
}

bool is_any(const PerSide<bool>& sides) { return sides[Side::kWest] || sides[Side::kEast]; }

std::string name_or_both(const std::optional<Side>& side) {
  return side ? std::string(name_of(*side)) : "each side";
}

bool is_due(const CardBook& cards, const RuleBook& rules, Card card) {
  if (rules.fouls_per_card == 0) return false;
  if (cards.fouls / rules.fouls_per_card <= cards.cards_for_fouls) return false;
  return next_card(cards, rules) == card;
}

std::optional<Finding> find_card(const RefereeState& state, const RefereeInput& input, Card card,
                                 Event event) {
  const RuleBook& rules = input.configuration.rules;
  PerSide<bool> due;
  int fouls = 0;
  for (const Side side : kSides) {
    due[side] = is_due(state.cards[side], rules, card);
    if (due[side]) fouls = std::max(fouls, state.cards[side].fouls);
  }
  if (!is_any(due)) return std::nullopt;
  Finding finding = finding_of(event, RuleId::kCards, rules);
  finding.offender = one_of(due);
  finding.card = card;
  finding.value = fouls;
  finding.threshold = rules.fouls_per_card;
  finding.unit = "fouls";
  finding.evidence =
      fmt::format("A {} card for {} after {} fouls; one is given every {}.", name_of(card),
                  name_or_both(finding.offender), fouls, rules.fouls_per_card);
  return finding;
}

}  // namespace

std::optional<Finding> find_yellow_card(RefereeState& state, const RefereeInput& input) {
  return find_card(state, input, Card::kYellow, Event::kYellowCard);
}

std::optional<Finding> find_red_card(RefereeState& state, const RefereeInput& input) {
  return find_card(state, input, Card::kRed, Event::kRedCard);
}

std::optional<Finding> find_card_over(RefereeState& state, const RefereeInput& input) {
  const double played_s = state.play_clock.at_s(input.time_s());
  PerSide<bool> over;
  for (const Side side : kSides) {
    const auto& ends_s = state.cards[side].yellow_ends_s;
    over[side] = !ends_s.empty() && has_passed(ends_s.front(), 0, played_s);
  }
  if (!is_any(over)) return std::nullopt;
  const RuleBook& rules = input.configuration.rules;
  Finding finding = finding_of(Event::kCardOver, RuleId::kCards, rules);
  finding.offender = one_of(over);
  finding.value = rules.card_s;
  finding.evidence = fmt::format("A yellow card of {} has lasted {:.0f} s of play.",
                                 name_or_both(finding.offender), rules.card_s);
  return finding;
}

}  // namespace autoref::referee
