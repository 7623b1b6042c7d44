// Guesses the rule book of a recorded game, and configures the game from the log, the rule book and
// the user's settings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "game/settings/game_settings.hpp"
#include "league/log_contents.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::logs {

// A rule book that a recorded game seems to have.
struct GuessedRules {
  std::string book;    // a name of find_rule_book()
  std::string reason;  // what it was guessed from, for people
};

// Guesses from the size of the field, the shape of its defence areas and the date of the recording.
// Until 2017 the areas were quarter circles; since 2018 they have been boxes, on fields of 12 m
// (Division A) or 9 m. A log without a date (its times count from 0, as in those of this program)
// on the single-size field gets the paper's rules.
GuessedRules guessed_rules(const league::LogSummary& log);

// The field according to the log's geometry; values that the geometry lacks come from the rule
// book's field. Vision does not say whether the goals' side walls reach the wall: they do as in the
// book if the walls are where the book has them.
Field field_in(const league::LogSummary& log, const Field& of_book);

// A game under the rule book, with field, robots, lengths and first kick-off overridden by the log,
// commanded by the recorded referee if there is one and by nobody otherwise.
// `recorded` is one of the log's games. Throws std::invalid_argument for an unknown rule book.
game::GameSettings logged_game(const std::string& book, const RecordedFacts& facts,
                               const RecordedGame& recorded);

// Throws std::invalid_argument if a referee cannot judge the game; the message begins with the
// invalid setting. Unlike in a simulation, margins need no space for a robot.
void check_judged(const game::GameSettings& game);

// One line for each setting that the log lacks and that is not in `is_set`: the value used instead
// and the option that sets it. `game` is the game to judge.
std::vector<std::string> gaps_of(const RecordedFacts& facts, const game::GameSettings& game,
                                 const std::function<bool(const std::string& path)>& is_set);

}  // namespace autoref::logs
