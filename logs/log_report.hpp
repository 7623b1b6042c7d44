// Reports of `autoref log info` and `autoref referee log` on a log.
#pragma once

#include <string>

#include "io/table.hpp"
#include "logs/log_referee.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::logs {

// Length, message types, field, cameras, score, and the number of times each command was sent or,
// with `lists_commands`, each command with its time.
std::string info_text(const RecordedFacts& facts, bool lists_commands);

// The same as a single-line JSON object, with all commands.
std::string info_json(const RecordedFacts& facts);

// The calls with which AutoRef's are compared.
struct Comparison {
  bool is_annotated = false;  // a person's annotations instead of the recorded commands
  std::string page;           // path of the page to link moments to (log_page.hpp); empty: none
};

// AutoRef's calls next to the recorded ones, and how well they agree.
io::TextBlocks referee_log_text(const LogRefereeResult& evaluation, const RecordedFacts& facts,
                                const Comparison& comparison = {});
std::string referee_log_json(const LogRefereeResult& evaluation, const RecordedFacts& facts,
                             const Comparison& comparison = {});

}  // namespace autoref::logs
