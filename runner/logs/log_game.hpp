// The game that a log shows, put together from what the log says, the rule book and the user.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runner/logs/recorded_facts.hpp"
#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

// A game by the book's rules, with what the log says of field, robots, lengths and first kick-off
// over them. `recorded` is one of the log's games. Throws std::invalid_argument for an unknown
// book.
GameSettings logged_game(const std::string& book, const RecordedFacts& facts,
                         const RecordedGame& recorded);

// Throws std::invalid_argument where a referee cannot judge such a game. The message begins with
// the setting that is wrong. Margins need no room for a simulated robot.
void check_judged(const GameSettings& game);

// A line for each setting that the log lacks and that is not in `is_set`: the value used instead,
// and the option that sets it. `game` is the game to judge.
std::vector<std::string> gaps_of(const RecordedFacts& facts, const GameSettings& game,
                                 const std::function<bool(const std::string& path)>& is_set);

}  // namespace autoref::runner
