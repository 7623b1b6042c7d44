// Knockouts: the winner of a tie goes on, the loser is out.
#pragma once

#include <string>
#include <vector>

#include "runner/experiments/named_teams.hpp"

namespace autoref::runner {

// A tie is one game by the base's rules. Where it is drawn, which knockout games (`match.knockout`)
// hardly ever are, or void, it is played again; where that does not help, the better seed goes on.
struct Knockout : NamedTeams {     // 2 to 64 teams
  std::vector<std::string> order;  // all of them, the best seed first
  bool third_place = false;        // whether the losers of the semi-finals play for it
};

inline constexpr std::size_t kMostInKnockout = 64;
inline constexpr int kMostAttempts = 6;  // games of one tie: five times again

}  // namespace autoref::runner
