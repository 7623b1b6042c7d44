// A log of the league that the user named.
#pragma once

#include <string>

#include "league/log_contents.hpp"

namespace autoref::runner {

// Shows the log to `visitor`. Says on stderr where the log is damaged or makes no sense. Throws
// InputError where it is no log or shows no picture.
league::LogSummary read_user_log(const std::string& path, league::LogVisitor& visitor);

}  // namespace autoref::runner
