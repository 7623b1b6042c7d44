// Round robins: each of several teams plays against each other.
#pragma once

#include <vector>

#include "runner/experiments/named_teams.hpp"

namespace autoref::runner {

struct RoundRobin : NamedTeams {
  int pairs = 1;  // of legs, per matchup; 1 to 9999
};

// Every two different teams, once: both ordered by their names, byte by byte.
std::vector<Matchup> matchups_of(const RoundRobin& robin);

}  // namespace autoref::runner
