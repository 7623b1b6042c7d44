// Games of the two teams of a comparison, as one of the teams sees them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "experiments/results/game_row.hpp"
#include "game/play_counts/play_counts.hpp"

namespace autoref::experiments {

// The games against one opponent, by the names of their matchups. The team in question is team a.
struct PairedOpponent {
  std::string of_new;
  // The old team's games with the same seeds; nullopt if the opponent is the old team.
  std::optional<std::string> of_old;
};

struct TeamGame {
  int goals = 0;
  int goals_against = 0;
  const game::PlayCounts* own = nullptr;
  const game::PlayCounts* opponents = nullptr;
};

// A number that a team has in a game.
using TeamNumber = std::function<double(const TeamGame&)>;

struct TeamNumbers {
  double of_a = 0;
  double of_b = 0;
};

// The number of each team of a matchup, on average over the legs of a pair. Both legs must have a
// row.
TeamNumbers mean_over_legs(const TeamNumber& number, const std::string& matchup, int pair,
                           const RowsById& rows);

// What chains of this kind begin with, in the plural: "corner kicks".
std::string_view plural_of(game::ChainStart start);

}  // namespace autoref::experiments
