// What is told of a match: a row for programs, a table for people.
#pragma once

#include <string>

#include "runner/analysis/groups.hpp"
#include "runner/analysis/sprt_match_state.hpp"

namespace autoref::runner {

// "d0", "d1", "undecided", or "none" as long as more pairs are needed.
std::string name_of(Verdict verdict);

// summary.csv: the matchup's row as a round robin has it, then the test: its verdict, how many
// pairs it took, how many of the first were left out as void, the log likelihood ratio of d1 to d0,
// and the test's settings.
std::string sprt_match_csv(const SprtMatch& match, const Group& matchup,
                           const SprtMatchState& state);

// The verdict in a sentence, and what it follows from.
std::string verdict_text(const SprtMatch& match, const SprtMatchState& state);

// The matchup's table, and the verdict.
std::string sprt_match_table(const SprtMatch& match, const Group& matchup,
                             const SprtMatchState& state);

}  // namespace autoref::runner
