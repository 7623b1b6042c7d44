// Guesses the rule book of a recorded game.
#pragma once

#include <string>

#include "league/log_contents.hpp"

namespace autoref::logs {

struct GuessedRules {
  std::string book;    // a name of find_rule_book()
  std::string reason;  // what it was guessed from, for people
};

// Guesses from the size of the field, the shape of its defence areas and the date of the recording.
// Until 2017 the areas were quarter circles; since 2018 they have been boxes, on fields of 12 m
// (Division A) or 9 m. A log without a date (its times count from 0, as in those of this program)
// on the single-size field gets the paper's rules.
GuessedRules guessed_rules(const league::LogSummary& log);

}  // namespace autoref::logs
