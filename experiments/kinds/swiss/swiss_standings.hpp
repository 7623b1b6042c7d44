// The standings of a Swiss tournament.
#pragma once

#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/analysis/standings.hpp"
#include "experiments/kinds/swiss/swiss_rounds.hpp"
#include "experiments/schedule/named_teams.hpp"

namespace autoref::experiments {

// The matchups of these rounds in the order of their first meetings, each once.
std::vector<Matchup> matchups_of(const SwissRounds& played);

// The teams in the order of the ranking, with the points of byes. They have ratings only if games
// link all teams, directly or through others, since ratings of unlinked teams cannot be compared.
std::vector<Standing> standings_of(const SwissRounds& played, const std::vector<Group>& matchups);

}  // namespace autoref::experiments
