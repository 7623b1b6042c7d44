// Reports of `autoref log info` and `autoref referee log` on a log.
#pragma once

#include <string>

#include "io/table.hpp"
#include "logs/log_referee.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::logs {

// A summary of a log: length, message types, field, cameras, score, and how often each command was
// sent. With `lists_commands`, it lists each command with its time instead.
std::string info_text(const RecordedFacts& facts, bool lists_commands);

// The summary as a single-line JSON object, with all commands.
std::string info_json(const RecordedFacts& facts);

// The calls with which AutoRef's are compared.
struct Comparison {
  bool is_annotated = false;  // the calls are a person's annotations, not the recorded commands
  std::string page;           // path of the page to link moments to (log_page.hpp); empty: none
};

// AutoRef's calls next to the recorded ones, and how well they agree.
io::TextBlocks referee_log_text(const LogRefereeResult& evaluation, const RecordedFacts& facts,
                                const Comparison& comparison = {});
std::string referee_log_json(const LogRefereeResult& evaluation, const RecordedFacts& facts,
                             const Comparison& comparison = {});

}  // namespace autoref::logs
