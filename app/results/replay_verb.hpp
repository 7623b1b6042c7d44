// A game of a results folder that the user names.
#pragma once

#include <string>

#include "experiments/run/result_folder.hpp"

namespace autoref::app {

// The game with this id. If only a game with the teams the other way round has it ("b~a-p0001-1"
// for "a~b-p0001-1"), that one, and a message on stderr names it; not in situations, whose teams
// attack and defend. In judged experiments, `id` may also be the id of a fault, which is then
// printed on stderr. Throws InputError for an unknown id, naming similar ones.
const experiments::ScheduledGame& game_named(const experiments::ResultFolder& folder,
                                             const std::string& id);

// The id with the two teams around its '~' exchanged; empty if it has none.
std::string turned_id(const std::string& id);

}  // namespace autoref::app
