// The standings of a Swiss tournament, and its rounds as a CSV file and as a text table.
#pragma once

#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/analysis/standings.hpp"
#include "experiments/kinds/results.hpp"
#include "experiments/kinds/swiss/swiss_rounds.hpp"
#include "experiments/schedule/matchup_schedule.hpp"

namespace autoref::experiments {

// The matchups of these rounds, each listed once, in the order of their first meetings.
std::vector<Matchup> matchups_of(const SwissRounds& played);

// The teams in the order of the ranking, including points for byes. The teams have ratings only if
// games link all teams, directly or through others, since ratings of unlinked teams cannot be
// compared.
std::vector<Standing> standings_of(const SwissRounds& played, const std::vector<Group>& matchups);

// rounds.csv: round by round, a row per meeting with its teams, numbers of games and void games,
// and points so far, then a row for the bye.
std::string rounds_csv(const SwissRounds& played);

// Adds rounds.csv, a table of rounds before the other tables, and a note after them on the points
// for a bye.
void add_rounds(ExperimentResults& results, const SwissRounds& played);

}  // namespace autoref::experiments
