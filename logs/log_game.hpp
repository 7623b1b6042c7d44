// Guesses the rule book of a recorded game and configures the game from the log, the rule book and
// the user's settings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "game/loop/event_log.hpp"
#include "game/settings/game_settings.hpp"
#include "league/log_contents.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::logs {

// The rule book that a recorded game seems to use.
struct GuessedRules {
  std::string book;    // a name of find_rule_book()
  std::string reason;  // what the guess is based on, as text
};

// Guesses the rule book from the size of the field, the shape of its defence areas and the date of
// the recording. Until 2017, the defence areas were quarter circles. Since 2018 they have been
// boxes, on fields of 12 m (Division A) or 9 m. A log without a date (with times that count from 0,
// as in this program's logs) on the single-size field gets the paper's rules.
GuessedRules guessed_rules(const league::LogSummary& log);

// The field according to the log's geometry; values that the geometry lacks come from the rule
// book's field, `of_book`. Vision does not say whether the goals' side walls reach the field's
// wall: the rule book decides this if the walls are where the rule book puts them.
Field field_in(const league::LogSummary& log, const Field& of_book);

// A game under the rule book, with field, robots, durations and first kick-off overridden by the
// log. If the log has a referee, that referee commands the game; otherwise nobody does. `recorded`
// is one of the log's games. Throws std::invalid_argument for an unknown rule book.
game::GameSettings logged_game(const std::string& book, const RecordedFacts& facts,
                               const RecordedGame& recorded);

// What the event lines of a recorded game say about the game. The field is the log's, so only rules
// and their numbers can differ from the official ones.
game::EventGame event_game_of(const PerSide<std::string>& names, const RuleBook& rules);

// Throws std::invalid_argument if a referee cannot judge a game with these settings; the message
// begins with the invalid setting. Unlike in a simulation, there need not be space for a robot
// outside the lines.
void check_judged(const game::GameSettings& game);

// One line for each setting that the log lacks and that is not in `is_set`: the line gives the
// value used instead and the option that sets it. `game` is the game to judge.
std::vector<std::string> gaps_of(const RecordedFacts& facts, const game::GameSettings& game,
                                 const std::function<bool(const std::string& path)>& is_set);

}  // namespace autoref::logs
