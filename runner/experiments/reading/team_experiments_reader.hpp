// Reads experiments between named teams.
#pragma once

#include "runner/experiments/gauntlet.hpp"
#include "runner/experiments/knockout.hpp"
#include "runner/experiments/reading/top_reader.hpp"
#include "runner/experiments/roundrobin.hpp"
#include "runner/experiments/sprt_match.hpp"

namespace autoref::runner {

// All of these functions throw InputError.
RoundRobin read_roundrobin(TopReader& top);
SprtMatch read_sprt_match(TopReader& top);
Gauntlet read_gauntlet(TopReader& top);
Knockout read_knockout(TopReader& top);

}  // namespace autoref::runner
