// By which rules a game is played, and what the referee is told of them.
#pragma once

#include <string>

#include "referee/referee.hpp"
#include "runner/settings/configuration.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::runner {

// Takes what belongs to the book of that name: its rules, field, robots and length of a half.
// Throws std::invalid_argument where there is none.
void choose_rules(const std::string& book, GameConfiguration& game);

// The match's rule book, with its rules as they are switched. Throws likewise.
RuleBook rules_of(const MatchConfiguration& match);

const TeamConfiguration& team_on(const GameConfiguration& game, Side side);

referee::Configuration referee_configuration(const GameConfiguration& game);

// A game that takes longer will not come to its end.
double longest_s(const MatchConfiguration& match);

}  // namespace autoref::runner
