// Knockouts: the winner of a tie advances, the loser is eliminated.
#pragma once

#include <string>
#include <vector>

#include "runner/experiments/named_teams.hpp"

namespace autoref::runner {

// A tie is one game under the base's rules. It is replayed if it is void or drawn, which is rare
// with `match.knockout`. If it is still undecided after kMostAttempts games, the better seed
// advances.
struct Knockout : NamedTeams {     // 2 to 64 teams
  std::vector<std::string> order;  // all teams, the best seed first
  bool third_place = false;        // whether the losers of the semi-finals play for third place
};

inline constexpr std::size_t kMostInKnockout = 64;
inline constexpr int kMostAttempts = 6;  // games of one tie, including five replays

}  // namespace autoref::runner
