// What `autoref log fit` prints and writes.
#pragma once

#include <string>
#include <vector>

#include "io/table.hpp"
#include "logs/fit/log_fit.hpp"

namespace autoref::logs {

// A table of all numbers with intervals and defaults, and estimates that are not settings.
io::TextBlocks fit_text(const LogFit& fit);

// The numbers as a single-line JSON object (docs/schemas.md).
std::string fit_json(const LogFit& fit);

// A file of kind `measured` (game/settings/measured_presets.hpp): ball, contacts and vision.
// `about` says where they come from, in one line. A number outside the range of its setting becomes
// the nearest one inside it; a number with too few observations is a comment.
std::string measured_yaml(const LogFit& fit, const std::string& about);

// A file of kind `robot` (game/settings/robot_types.hpp): the team's robots, with the kicks of all
// teams. It has no turning rates below the defaults, since teams rarely turn as fast as their
// robots can, and a limit of the wheels that allows what was reached.
std::string robots_yaml(const LogFit& fit, const FittedTeam& team, const std::string& about);

// The team's name in a file's name: lower case, with - for everything but letters and digits, at
// most 40 characters. "team" if nothing remains.
std::string file_word(const std::string& team);

}  // namespace autoref::logs
