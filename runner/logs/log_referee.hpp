// AutoRef judges a recorded game from its vision packets alone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "referee/referee.hpp"
#include "runner/logs/calls.hpp"
#include "runner/logs/recorded_facts.hpp"

namespace autoref::runner {

struct LogRefereeResult {
  Agreement agreement;  // of AutoRef's calls with the recorded referee's
  PerSide<int> goals;   // by AutoRef
  std::string events;   // its decisions, a JSON object a line (event_log.hpp)
  int decisions = 0;
};

// Judges every frame of the log in order. Each of the log's games has its configuration and its own
// referee; the last configuration serves those that have none. Goals are those of the last game.
// Where the recorded referee says that blue defends the
// goal at -x, frames are turned round, as AutoRef takes yellow to be west. Throws
// league::LogError, and std::invalid_argument where a configuration makes no referee. There is at
// least one.
LogRefereeResult referee_log(const std::filesystem::path& log, const RecordedFacts& facts,
                             const std::vector<referee::Configuration>& configurations);

}  // namespace autoref::runner
