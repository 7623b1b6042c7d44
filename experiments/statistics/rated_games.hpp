// Games between several teams, as input of the ratings.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace autoref::experiments {

struct RatedGame {
  double difference = 0;  // goals of team a minus goals of team b
  double win = 0;         // 1 if a won, 1/2 for a draw, 0 if b won
};

// All valid games between two teams, by pair number: one or two legs each.
struct RatedMatchup {
  std::string team_a;
  std::string team_b;
  std::map<int, std::vector<RatedGame>> pairs;
};

// Sums over the games of two teams, which are numbered from 0.
struct MatchupTotals {
  std::size_t a = 0;
  std::size_t b = 0;
  double games = 0;
  double difference = 0;
  double wins = 0;   // a's wins, draws counting one half
  double draws = 0;  // drawn games
};

}  // namespace autoref::experiments
