// A game of a results folder that the user names.
#pragma once

#include <string>

#include "experiments/run/result_folder.hpp"

namespace autoref::app {

// The game with this id. If it exists only with the teams swapped ("b~a-p0001-1" for
// "a~b-p0001-1"), returns that game and names it on stderr, except in situations, where one team
// attacks and the other defends. In judged experiments, `id` can also be the id of a fault, which
// is then printed on stderr. Throws InputError for an unknown id, naming similar ones.
const experiments::ScheduledGame& game_named(const experiments::ResultFolder& folder,
                                             const std::string& id);

// The id with the two teams around its '~' swapped; empty if `id` has no '~'.
std::string turned_id(const std::string& id);

}  // namespace autoref::app
