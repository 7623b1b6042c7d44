// Who plays whom in a round of a Swiss tournament.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace autoref::experiments {

using DrawnTeam = std::size_t;  // a team's number in the draw, from 0

// What teams have done in earlier rounds.
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
  std::vector<std::pair<DrawnTeam, DrawnTeam>> meetings;  // from the top
  std::optional<DrawnTeam> bye;                           // of an odd number of teams
};

// The first round: the top half of the draw against the bottom half, in order. An odd team out,
// the last of the draw, has a bye.
RoundPairing first_pairing(std::size_t teams);

// A later round. `ranking` has all teams, the best first.
//
// From the top, each team meets the next one below it that it has not met, provided that the teams
// left over can still be paired without rematches: the first pairing that a search with
// backtracking would find. Instead of backtracking, each choice is checked with a matching of the
// teams left over that is as large as possible (J. Edmonds, "Paths, trees, and flowers", Canadian
// Journal of Mathematics 17, 1965), so that the work is bounded by a polynomial.
//
// Of an odd number of teams, the lowest that has had none gets a bye, unless that forces more
// rematches than a bye of another such team.
//
// If n teams play, those of a bye left out, and each has met at most n / 2 - 1 others, a pairing
// without rematches exists (G. A. Dirac, "Some theorems on abstract graphs", Proceedings of the
// London Mathematical Society 2, 1952). After more rounds there may be none: if six teams have
// played three rounds, those left to meet may be two groups of three. Then the round has as few
// rematches as possible.
//
// Throws std::logic_error if the number of teams is odd and all have had a bye.
RoundPairing next_pairing(const std::vector<DrawnTeam>& ranking, const Encounters& past);

}  // namespace autoref::experiments
