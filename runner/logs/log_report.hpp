// What `autoref info` and `autoref referee` say of a log.
#pragma once

#include <string>

#include "runner/logs/log_referee.hpp"
#include "runner/logs/recorded_facts.hpp"

namespace autoref::runner {

// Length, kinds of messages, field, cameras, score, and how often each command was sent; with
// `lists_commands` each with its time.
std::string info_text(const RecordedFacts& facts, bool lists_commands);

// The same as one JSON object on one line, with every command.
std::string info_json(const RecordedFacts& facts);

// AutoRef's calls beside the recorded ones, and how well they agree.
std::string referee_log_text(const LogRefereeResult& evaluation, const RecordedFacts& facts);
std::string referee_log_json(const LogRefereeResult& evaluation, const RecordedFacts& facts);

}  // namespace autoref::runner
