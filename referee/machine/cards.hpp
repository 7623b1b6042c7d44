// Fouls that count, yellow and red cards, and how many robots a side may have (Laws 12; 2026).
#pragma once

#include <string>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// What a side with these cards is shown next: where the book says so, the third active yellow card
// is a red one instead (2026).
Card next_card(const CardBook& cards, const RuleBook& rules);

// Why a finding brings the offender, or both sides, that card: "6th foul, and every 3rd gives a
// card". `before` are the cards until then.
std::string card_reason(const PerSide<CardBook>& before, const Finding& finding, Card shown,
                        const RuleBook& rules);

// Counts the finding's foul against the offender, or against both sides where there is none, and
// shows the card that it gives, if cards are in force.
void book(RefereeState& state, const RefereeInput& input, const Finding& finding);

// Takes the oldest yellow card off the finding's offender, or off both sides where there is none.
void take_card_off(RefereeState& state, const Configuration& configuration, const Finding& finding);

// Sets how many robots each side may have on the field: one fewer for each card in force, and
// never fewer than one.
void allow_robots(RefereeState& state, const Configuration& configuration);

}  // namespace autoref::referee
