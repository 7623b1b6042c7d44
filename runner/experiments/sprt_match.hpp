// SPRT matches: two teams play until a sequential test accepts one of two hypotheses.
#pragma once

#include "runner/experiments/named_teams.hpp"
#include "runner/statistics/sequential_test.hpp"

namespace autoref::runner {

struct SprtMatch : NamedTeams {  // two teams
  SequentialTest sprt;           // tests the goal difference, team a minus team b
};

// Both teams, as in a round robin: team a is the first by name (compared as bytes).
Matchup matchup_of(const SprtMatch& match);

}  // namespace autoref::runner
