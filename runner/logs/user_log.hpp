// A log of the league that the user named.
#pragma once

#include <string>

#include "league/log_contents.hpp"
#include "runner/logs/recorded_facts.hpp"

namespace autoref::runner {

// Where the log stops making sense, how many of its messages make none, and what is odd about it;
// lines for stderr, empty where all is well.
std::string damage_text(const std::string& path, const league::LogSummary& log);

// The same, and what is odd about its games.
std::string damage_text(const std::string& path, const RecordedFacts& facts);

// Shows the log to `visitor`. Says on stderr where the log is damaged or makes no sense. Throws
// InputError where it is no log or shows no frame.
league::LogSummary read_user_log(const std::string& path, league::LogVisitor& visitor);

// The log's field; where it has none that of the rule book, which is said on stderr. Throws
// InputError for an unknown book.
Field field_shown(const std::string& path, const league::LogSummary& log, const std::string& book);

}  // namespace autoref::runner
