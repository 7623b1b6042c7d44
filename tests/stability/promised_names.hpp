// The names that 1.x promises to keep (docs/stability.md), as lists in tests/stability/.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace autoref::stability {

using Names = std::vector<std::string>;

// A list and the names in the current program.
struct PromisedList {
  std::string file;
  Names (*names)();
};

inline void PrintTo(const PromisedList& list, std::ostream* out) { *out << list.file; }

Names setting_names();       // "teams.a.robots", and "match.rules = paper" for words
Names written_names();       // "results.csv: game_id"
Names event_names();         // "throw_in"
Names command_line_names();  // "play --seed"
Names exit_code_names();     // "2 bad input"
Names message_names();       // in the messages of team programs, in each encoding
Names network_names();       // "vision 224.5.23.2:10006"

}  // namespace autoref::stability
