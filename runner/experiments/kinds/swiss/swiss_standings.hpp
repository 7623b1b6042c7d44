// The standings of a Swiss tournament.
#pragma once

#include <vector>

#include "runner/analysis/groups.hpp"
#include "runner/analysis/standings.hpp"
#include "runner/experiments/kinds/swiss/swiss_rounds.hpp"
#include "runner/experiments/named_teams.hpp"

namespace autoref::runner {

// The matchups of these rounds in the order of their first meetings, each once.
std::vector<Matchup> matchups_of(const SwissRounds& played);

// The teams in the order of the ranking, with the points of byes. They have ratings only if games
// link all teams, directly or through others, since ratings of unlinked teams cannot be compared.
std::vector<Standing> standings_of(const SwissRounds& played, const std::vector<Group>& matchups);

}  // namespace autoref::runner
