// An SPRT match's results as a CSV file and as a text table.
#pragma once

#include <string>

#include "experiments/analysis/groups.hpp"
#include "experiments/kinds/sprt/sprt_match_state.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// "d0", "d1", "undecided", or "none" while more pairs are needed.
std::string name_of(Verdict verdict);

// summary.csv: the matchup's row as in a round robin, then the test: its verdict, the number of
// pairs used, the number of pairs left out because of a void leg, the log-likelihood ratio of d1 to
// d0, and the test's settings.
std::string sprt_match_csv(const SprtMatch& match, const Group& matchup,
                           const SprtMatchState& state);

// The verdict as a sentence, then the number of pairs, the log-likelihood ratio and its bounds.
std::string verdict_text(const SprtMatch& match, const SprtMatchState& state);

// The matchup's table, followed by the verdict.
io::TextBlocks sprt_match_table(const SprtMatch& match, const Group& matchup,
                                const SprtMatchState& state);

}  // namespace autoref::experiments
