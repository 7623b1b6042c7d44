// Gauntlets: challengers against a fixed field of teams.
#pragma once

#include <vector>

#include "runner/experiments/named_teams.hpp"

namespace autoref::runner {

struct Gauntlet : NamedTeams {  // its teams are the field
  Teams challengers;            // of other names than the field's
  int pairs = 1;                // of legs, per matchup; 1 to 9999
};

// Every challenger, as team a, with every team of the field; both ordered by their names. Neither
// challengers nor teams of the field meet among themselves.
std::vector<Matchup> matchups_of(const Gauntlet& gauntlet);

// Challengers and field in one.
NamedTeams everyone_in(const Gauntlet& gauntlet);

}  // namespace autoref::runner
