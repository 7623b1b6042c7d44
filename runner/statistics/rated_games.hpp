// The games of several teams against each other, as ratings read them.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace autoref::runner {

struct RatedGame {
  double difference = 0;  // goals of the matchup's a minus b's
  double win = 0;         // 1 where a won, 1/2 for a draw, 0 where b won
};

// All games of two teams that count, by pair number: one or two legs each.
struct RatedMatchup {
  std::string team_a;
  std::string team_b;
  std::map<int, std::vector<RatedGame>> pairs;
};

// Sums over games of two teams, which are numbered from 0.
struct MatchupTotals {
  std::size_t a = 0;
  std::size_t b = 0;
  double games = 0;
  double difference = 0;
  double wins = 0;  // a's, draws as halves
};

}  // namespace autoref::runner
