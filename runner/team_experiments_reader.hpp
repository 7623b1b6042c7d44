// Reads the experiments between teams that have names. For scenario.cpp.
#pragma once

#include "runner/gauntlet.hpp"
#include "runner/knockout.hpp"
#include "runner/match.hpp"
#include "runner/roundrobin.hpp"
#include "runner/top_reader.hpp"

namespace autoref::runner {

// Each throws InputError.
RoundRobin read_roundrobin(TopReader& top);
Match read_match(TopReader& top);
Gauntlet read_gauntlet(TopReader& top);
Knockout read_knockout(TopReader& top);

}  // namespace autoref::runner
