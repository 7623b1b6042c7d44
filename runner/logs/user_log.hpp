// A log of the league that the user named.
#pragma once

#include <string>

#include "league/log_contents.hpp"

namespace autoref::runner {

// Where the log stops making sense, and how many of its messages make none; lines for stderr, empty
// where all is well.
std::string damage_text(const std::string& path, const league::LogSummary& log);

// Shows the log to `visitor`. Says on stderr where the log is damaged or makes no sense. Throws
// InputError where it is no log or shows no frame.
league::LogSummary read_user_log(const std::string& path, league::LogVisitor& visitor);

}  // namespace autoref::runner
