// Matches: two teams play until a sequential test tells which of two claims holds.
#pragma once

#include "runner/experiments/named_teams.hpp"
#include "runner/statistics/sequential_test.hpp"

namespace autoref::runner {

struct SprtMatch : NamedTeams {  // two teams
  SequentialTest sprt;           // about the goals of the first team by name minus the other's
};

// Both teams, the first by name, byte by byte, being team a: as in a round robin.
Matchup matchup_of(const SprtMatch& match);

}  // namespace autoref::runner
