// The rounds of a Swiss tournament: the pairings determined by its rows so far.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/kinds/swiss/swiss.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

using DrawnTeam = std::size_t;  // a team's number in the draw, from 0

// The teams' meetings and byes in earlier rounds.
class Encounters {
 public:
  explicit Encounters(std::size_t teams) : met_(teams, std::vector<bool>(teams)), had_bye_(teams) {}

  bool have_met(DrawnTeam one, DrawnTeam other) const { return met_[one][other]; }
  bool had_bye(DrawnTeam team) const { return had_bye_[team]; }
  void add_meeting(DrawnTeam one, DrawnTeam other) { met_[one][other] = met_[other][one] = true; }
  void add_bye(DrawnTeam team) { had_bye_[team] = true; }

 private:
  std::vector<std::vector<bool>> met_;
  std::vector<bool> had_bye_;
};

struct RoundPairing {
  std::vector<std::pair<DrawnTeam, DrawnTeam>> meetings;  // meetings, from the top of the ranking
  // Team with the bye, if the number of teams is odd.
  std::optional<DrawnTeam> bye;
};

// The first round: the top half of the draw against the bottom half, in order. If the number of
// teams is odd, the last team of the draw has a bye.
RoundPairing first_pairing(std::size_t teams);

// Pairs a later round. `ranking` contains all teams, the best first.
//
// From the top, each team plays the next one below it that it has not met, provided that the
// remaining teams can still be paired without rematches. This is the first pairing that a search
// with backtracking would find. Instead of backtracking, each choice is checked with a maximum
// matching of the remaining teams (J. Edmonds, "Paths, trees, and flowers", Canadian Journal of
// Mathematics 17, 1965), so the work is polynomial.
//
// If the number of teams is odd, the lowest-ranked team that has had no bye gets one, unless that
// forces more rematches than giving it to another team without one.
//
// If n teams play (not counting a bye) and each has met at most n / 2 - 1 others, a pairing without
// rematches exists (G. A. Dirac, "Some theorems on abstract graphs", Proceedings of the London
// Mathematical Society 2, 1952). After more rounds there may be none: after three rounds of six
// teams, the pairs that have not met yet may form two triangles. The round then has as few
// rematches as possible.
//
// Throws std::logic_error if the number of teams is odd and all have had a bye.
RoundPairing next_pairing(const std::vector<DrawnTeam>& ranking, const Encounters& past);

// The results of all games between two teams in a round.
struct Meeting {
  Matchup teams;  // team a has the name that sorts first
  int games = 0;  // number of games that have rows and are not void
  int void_games = 0;
  int points_a = 0;  // 3 points for each game won, 1 for each draw
  int points_b = 0;
};

struct SwissRound {
  std::vector<Meeting> meetings;   // meetings, from the top of the ranking
  std::optional<std::string> bye;  // the team that does not play, if the number of teams is odd
};

struct SwissRounds {
  std::vector<SwissRound> rounds;    // rounds with known meetings
  std::vector<std::string> ranking;  // all teams, the best first
  std::map<std::string, int> byes;   // number of byes, for teams that have had at least one
  // Points for a bye: as many as for winning all games of a meeting.
  int points_of_bye = 0;
};

int games_per_meeting(const Swiss& swiss);

// All teams in a shuffled order that depends only on the master seed and their names.
std::vector<std::string> draw_of(const Swiss& swiss);

// The rounds determined by these rows: when a round is complete, the next one is known. Teams are
// ranked by points, then by goal difference per game, then by the draw. Void games count only in
// `void_games`.
SwissRounds rounds_of(const Swiss& swiss, const RowsById& rows);

// All rounds as they would be paired if every game were drawn.
SwissRounds rounds_if_drawn(const Swiss& swiss);

// The games of these rounds. In each round, all meetings play a pair of legs before the next pair.
// The legs of a pair form a unit (ScheduledGame::unit).
//
// Pair k of round r is pair number (r - 1) * pairs + k in ids, rows and seeds, "bold~zone-p0007-2",
// so that games of different rounds have different seeds. A game depends only on its two teams, its
// pair number and its leg, not on the ranking.
std::vector<ScheduledGame> games_of(const Swiss& swiss, const SwissRounds& played);

}  // namespace autoref::experiments
