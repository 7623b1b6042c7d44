// Fouls that count, yellow and red cards, and how many robots a side may have (Laws 12; 2026).
#pragma once

#include "referee/finding.hpp"
#include "referee/memory.hpp"
#include "referee/moment.hpp"

namespace autoref::referee {

// Counts the finding's foul against the offender, or against both sides where there is none, and
// shows the card that it gives.
void book(Memory& memory, const Configuration& configuration, const Finding& finding);

// Sets how many robots each side may have on the field: one fewer for each card in force.
void allow_robots(Memory& memory, const Configuration& configuration);

}  // namespace autoref::referee
