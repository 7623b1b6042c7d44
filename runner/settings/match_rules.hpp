// Derives the rule book and the referee's configuration from a match's settings.
#pragma once

#include <string>

#include "referee/referee.hpp"
#include "runner/settings/configuration.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::runner {

// Applies the book of that name: its rules, field, number of robots and length of a half. Throws
// std::invalid_argument if there is no such book.
void choose_rules(const std::string& book, GameConfiguration& game);

// The match's rule book with its rules switched as configured. Throws like choose_rules().
RuleBook rules_of(const MatchConfiguration& match);

const TeamConfiguration& team_on(const GameConfiguration& game, Side side);

referee::Configuration referee_configuration(const GameConfiguration& game);

// Time limit of a game, in seconds: a game that takes longer will never end.
double longest_s(const MatchConfiguration& match);

}  // namespace autoref::runner
