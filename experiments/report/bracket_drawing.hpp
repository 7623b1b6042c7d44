// The layout of a bracket: one column per round, with each tie next to the two ties whose winners
// play it.
#pragma once

#include <string>
#include <vector>

#include "experiments/report/document.hpp"

namespace autoref::experiments {

// The numbers of ties in the rounds, including byes, from the first round to the final: 4, 2, 1. In
// a cup of more than 64 teams, only the last rounds are laid out.
std::vector<std::size_t> rounds_of(const CupBracket& bracket);

// The bracket as an HTML element. page_bracket_style() (view/page_parts.hpp) lays it out as columns
// of ties with lines between them or, on a phone, as a list of rounds.
std::string bracket_html(const CupBracket& bracket);

}  // namespace autoref::experiments
