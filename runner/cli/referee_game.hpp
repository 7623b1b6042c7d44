// The game that `autoref referee` judges, from a log or from the network.
#pragma once

#include <string>

#include "runner/cli/command_line.hpp"
#include "runner/logs/recorded_facts.hpp"
#include "runner/settings/assignments.hpp"
#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

// The rule book must be chosen first: it provides field, robots and lengths, which the facts then
// override. Throws InputError if an assignment chooses it.
void refuse_book_among(const Assignments& assignments);

// The rule book chosen, or else guessed, which is said on stderr. `source` names the log or the
// network.
std::string book_of(const RefereeArguments& arguments, const RecordedFacts& facts,
                    const std::string& source);

// The game under that book, with the facts and the user's settings. Throws InputError if it cannot
// be refereed.
GameSettings game_of(const RefereeArguments& arguments, const std::string& book,
                     const Assignments& assignments, const RecordedFacts& facts,
                     const RecordedGame& recorded, const std::string& source);

// Says on stderr which settings the facts lack.
void say_gaps(const RefereeArguments& arguments, const Assignments& assignments,
              const RecordedFacts& facts, const GameSettings& game, const std::string& source);

}  // namespace autoref::runner
