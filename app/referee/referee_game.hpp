// The game that `autoref referee` judges, from a log or from the network.
#pragma once

#include <string>

#include "app/command_line.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::app {

// The rule book must be chosen first: it provides field, robots and lengths, which the facts then
// override. Throws InputError if an assignment chooses it.
void refuse_book_among(const game::Assignments& assignments);

// The rule book chosen, or else guessed, which is said on stderr. `source` names the log or the
// network.
std::string book_of(const RefereeArguments& arguments, const logs::RecordedFacts& facts,
                    const std::string& source);

// The game under that book, with the facts and the user's settings. Throws InputError if it cannot
// be refereed.
game::GameSettings game_of(const RefereeArguments& arguments, const std::string& book,
                           const game::Assignments& assignments, const logs::RecordedFacts& facts,
                           const logs::RecordedGame& recorded, const std::string& source);

// Says on stderr which settings the facts lack.
void say_gaps(const RefereeArguments& arguments, const game::Assignments& assignments,
              const logs::RecordedFacts& facts, const game::GameSettings& game,
              const std::string& source);

}  // namespace autoref::app
