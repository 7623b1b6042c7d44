// Situations taken from a log.
#pragma once

#include <filesystem>

#include "experiments/kinds/situations/situation.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::experiments {

struct LoggedInstant {
  std::filesystem::path log;
  double at_s = 0;               // in seconds from the start of the log
  Side attackers = Side::kWest;  // west is yellow
  double spread_m = 0;           // standard deviation added to every coordinate of a position
};

// Sets robots, ball and restart to those of the log, with positions rounded to 0.1 mm. Robots with
// numbers that a team of this size lacks get other numbers. Throws std::invalid_argument.
void take_from_log(const LoggedInstant& instant, const Field& field, int most_attackers,
                   int most_defenders, SituationSetup& situation);

}  // namespace autoref::experiments
