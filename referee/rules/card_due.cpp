// Cards for fouls, and the end of yellow cards. "Every third foul of the same team results in a
// yellow card"; a third active yellow card becomes a red one (2026). A yellow card lasts for a
// fixed time of play (Laws 12).
//
// If both sides are due a card in one frame, one finding without an offender covers both.
#include <fmt/format.h>

#include <algorithm>

#include "referee/machine/cards.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

// The side concerned; nullopt if both sides are.
std::optional<Side> one_of(const PerSide<bool>& sides) {
  if (sides[Side::kWest] && sides[Side::kEast]) return std::nullopt;
  return sides[Side::kWest] ? Side::kWest : Side::kEast;
}

bool is_any(const PerSide<bool>& sides) { return sides[Side::kWest] || sides[Side::kEast]; }

std::string name_or_both(const std::optional<Side>& side) {
  return side ? std::string(colour_of(*side)) : "each side";
}

bool is_due(const CardBook& cards, const RuleBook& rules, Card card) {
  if (rules.fouls_per_card == 0) return false;
  // The integer division gives the cards earned so far, which are compared with the cards shown.
  if (cards.fouls / rules.fouls_per_card <= cards.cards_for_fouls) return false;
  return next_card(cards, rules) == card;
}

std::optional<Finding> find_card(const RefereeState& state, const RefereeInput& input,
                                 Event event) {
  const Card card = entry_of(event).card;
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
  finding.value = fouls;
  finding.threshold = rules.fouls_per_card;
  finding.unit = "fouls";
  finding.evidence =
      fmt::format("{} card for {}: {}.", name_of(card), name_or_both(finding.offender),
                  card_reason(state.cards, finding, card, rules));
  return finding;
}

std::optional<Finding> find_yellow_card(RefereeState& state, const RefereeInput& input) {
  return find_card(state, input, Event::kMultipleFouls);
}

std::optional<Finding> find_red_card(RefereeState& state, const RefereeInput& input) {
  return find_card(state, input, Event::kMultipleCards);
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

}  // namespace

constinit const Rule kCardsRule{{{State::kRun, State::kWaitStop}, find_red_card},
                                {{State::kRun, State::kWaitStop}, find_yellow_card},
                                {{State::kRun}, find_card_over}};

}  // namespace autoref::referee
