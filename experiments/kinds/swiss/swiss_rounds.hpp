// The rounds of a Swiss tournament, as far as its rows decide them.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/swiss/swiss.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/schedule/named_teams.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

// All games of two teams in a round.
struct Meeting {
  Matchup teams;  // team a is the one whose name comes first
  int games = 0;  // with rows, without void games
  int void_games = 0;
  int points_a = 0;  // 3 for each game won, 1 for each drawn one
  int points_b = 0;
};

struct SwissRound {
  std::vector<Meeting> meetings;   // from the top of the ranking
  std::optional<std::string> bye;  // the team that does not play, if the number of teams is odd
};

struct SwissRounds {
  std::vector<SwissRound> rounds;    // those whose meetings are known
  std::vector<std::string> ranking;  // all teams, the best first
  std::map<std::string, int> byes;   // of teams that have had one
  int points_of_bye = 0;             // as many as for winning all games of a meeting
};

int games_per_meeting(const Swiss& swiss);

// All teams in the order of a shuffle that depends on the master seed and their names only.
std::vector<std::string> draw_of(const Swiss& swiss);

// The rounds that follow from these rows: each complete round is followed by the next. Teams are
// ranked by points, then by goal difference per game, then by the draw. Void games count only in
// `void_games`.
SwissRounds rounds_of(const Swiss& swiss, const RowsById& rows);

// All rounds, if every game is drawn.
SwissRounds rounds_if_drawn(const Swiss& swiss);

// The games of these rounds. In each round, a pair of legs is played in all meetings before the
// next, and the legs of a pair are a unit.
//
// Pair k of round r is pair number (r - 1) * pairs + k in ids, rows and seeds, "bold~zone-p0007-2",
// so that games of different rounds have different seeds. A game depends only on its two teams, its
// pair number and its leg, not on the ranking.
std::vector<ScheduledGame> games_of(const Swiss& swiss, const SwissRounds& played);

}  // namespace autoref::experiments
