// The bracket of a knockout: its ties, their teams, who advances, and the games to play.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/knockout/knockout.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

enum class DecidedBy { kNothing, kGoals, kExtraTime, kShootout, kForfeit, kSeed };

// "goals", "extra time", "shoot-out", "forfeit", "better seed"; "" if undecided.
std::string name_of(DecidedBy decided_by);

struct Tie {
  int number = 1;                     // counted from 1 over all rounds
  std::string name;                   // "quarter-final 2", "final", "third place"
  std::optional<BracketPlace> place;  // nullopt for the tie for third place
  // The two teams; team a is the better seed. A team is nullopt until the preceding tie is decided.
  std::optional<std::string> a;
  std::optional<std::string> b;
  std::vector<std::string> games;  // ids of the games played so far, in order
  int void_games = 0;
  DecidedBy decided_by = DecidedBy::kNothing;
  bool a_won = false;

  bool is_known() const { return a.has_value() && b.has_value(); }
  bool is_decided() const { return decided_by != DecidedBy::kNothing; }
};

// Returns the ties round by round; the final comes last, followed only by the tie for third place.
// Standard seeding: the best seed plays the worst in the first round, and if the better seed wins
// every tie, the two best seeds play the final. If the number of teams is not a power of two, the
// best seeds get a bye in the first round. `decide` is called for each tie with two known teams.
std::vector<Tie> bracket_of(const Knockout& knockout, const std::function<void(Tie&)>& decide);

// The bracket's ties with their winners and the games played so far.
std::vector<Tie> bracket_of(const Knockout& knockout, const RowsById& rows);

// The games known so far: the games already played in these ties and the next game of each
// undecided tie with two known teams.
//
// In ids, rows and seeds, the number of the tie replaces that of the pair, and the number of the
// attempt replaces that of the leg: "cobalt~zone-p0007-1", and after a draw "cobalt~zone-p0007-2".
// The better seed is team a and starts in the west; in each replay the teams change ends, and the
// other team kicks off first. All games of a tie belong to the same shard.
std::vector<ScheduledGame> games_of(const Knockout& knockout, const std::vector<Tie>& ties);

}  // namespace autoref::experiments
