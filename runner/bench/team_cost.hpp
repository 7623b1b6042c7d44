// Measures how long teams take to decide.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace autoref::runner {

// Decision time of one team.
struct TeamCost {
  std::string name;
  double ns_per_decision = 0;  // for the whole team; mean over a game against itself
  std::int64_t decisions = 0;  // made by both teams in that game
};

// Measures a registered team in a fixed game against itself: six against six, two halves of 300 s.
// Reading the clock adds about 30 ns. Throws std::invalid_argument for an unknown name, and
// std::logic_error if the game is void.
TeamCost cost_of_team(std::string_view name);

}  // namespace autoref::runner
