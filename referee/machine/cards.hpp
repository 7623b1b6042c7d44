// Fouls that count towards cards, yellow and red cards, and the number of robots allowed per side
// (Laws 12; 2026).
#pragma once

#include <string>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// The next card for a side that already has these cards. If the rule book says so, the third active
// yellow card becomes a red one (2026).
Card next_card(const CardBook& cards, const RuleBook& rules);

// Why a finding brings the card `shown` to the offender, or to both sides: "6th foul (every 3rd
// brings a card)". `before` holds the cards shown so far.
std::string card_reason(const PerSide<CardBook>& before, const Finding& finding, Card shown,
                        const RuleBook& rules);

// Counts the finding's foul against the offender, or against both sides if there is none, without
// showing a card.
void count_foul(RefereeState& state, const RefereeInput& input, const Finding& finding);

// Compares the number of robots allowed per side with `before`. For each side where it differs,
// records that it changed in this frame.
void note_robots_allowed(RefereeState& state, const RefereeInput& input,
                         const PerSide<int>& before);

// Counts the finding's foul against the offender, or against both sides if there is none. If cards
// are in force, shows any card that is due.
void book(RefereeState& state, const RefereeInput& input, const Finding& finding);

// Ends the oldest yellow card of the finding's offender, or of both sides if there is no offender.
void take_card_off(RefereeState& state, const Configuration& configuration, const Finding& finding);

// Sets the number of robots that each side may have on the field: one fewer for each card in force,
// but at least one.
void allow_robots(RefereeState& state, const Configuration& configuration);

}  // namespace autoref::referee
