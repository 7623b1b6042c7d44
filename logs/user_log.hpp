// Reads an SSL log named by the user and reports its oddities.
#pragma once

#include <string>
#include <vector>

#include "league/log_contents.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::logs {

// The logs that `paths` name: a folder stands for its .log and .log.gz files, sorted by name,
// without those in folders below. Throws InputError if a folder contains none, cannot be read, or
// has more than kMostLogs files.
inline constexpr std::size_t kMostLogs = 10'000;
std::vector<std::string> logs_in(const std::vector<std::string>& paths);

// A path from which the log can be read several times: `path` itself or, if that is a pipe, an
// unnamed copy that disappears when the program ends. Throws InputError if the log cannot be
// opened, and InputOutputError if it cannot be copied.
std::string seekable_log(const std::string& path);

// Reads the whole log from a copy returned by seekable_log(). Throws InputError if the file is not
// a log.
RecordedFacts read_facts(const std::string& path, const std::string& copy,
                         league::FrameSource source = league::FrameSource::kFirst);

// The message about an error in a log, with the path given by the user in place of the copy's path.
std::string text_of(const league::LogError& error, const std::string& copy,
                    const std::string& path);

// Descriptions of the faults in the messages of a recorded or live game, without line breaks.
std::vector<std::string> texts_of(const league::MessageFaults& faults);

// Lines for stderr: where the log is damaged, how many of its messages are ignored, and other
// oddities. Empty if there are none.
std::string damage_text(const std::string& path, const league::LogSummary& log);

// The lines of damage_text() for the summary, followed by lines about oddities of the games in the
// log.
std::string damage_text(const std::string& path, const RecordedFacts& facts);

// Feeds the log to `visitor`. Reports damage and ignored messages on stderr. Throws InputError if
// the file is not a log or contains no frame.
league::LogSummary read_user_log(const std::string& path, league::LogVisitor& visitor);

// The log's field. If the log has no geometry, it is the field of the rule book, which is reported
// on stderr. Throws InputError for an unknown rule book.
Field field_shown(const std::string& path, const league::LogSummary& log, const std::string& book);

}  // namespace autoref::logs
