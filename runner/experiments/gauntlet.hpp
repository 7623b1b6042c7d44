// Gauntlets: challengers against a fixed field of teams.
#pragma once

#include <vector>

#include "runner/experiments/named_teams.hpp"

namespace autoref::runner {

struct Gauntlet : NamedTeams {  // `teams` is the field
  Teams challengers;            // no names in common with the field
  int pairs = 1;                // pairs of legs per matchup, 1 to 9999
};

// Pairs every challenger, as team a, with every team of the field, in the order of their names.
// Challengers do not play each other, and neither do the teams of the field.
std::vector<Matchup> matchups_of(const Gauntlet& gauntlet);

// The challengers and the field combined.
NamedTeams everyone_in(const Gauntlet& gauntlet);

}  // namespace autoref::runner
