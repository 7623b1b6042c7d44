// Samples of games to which the win probability and the value of situations are fitted.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "game/play_counts/situation_value.hpp"
#include "game/play_counts/win_probability.hpp"
#include "soccer/side.hpp"
#include "tools/fitting/fitted_games.hpp"

namespace autoref::tools {

inline constexpr int kQuarters = 4;

// The ball's owner and the features of the situation.
struct OwnedBall {
  Side owner = Side::kWest;
  std::optional<double> shot_chance = {};
  std::array<double, game::kValueFeatures> features{};

  game::SituationValue value(const game::ValueModel& model) const {
    return model.value(features, shot_chance);
  }
};

// A spell of play, or the stop before it, in a frame drawn at random.
struct SpellSample {
  OwnedBall ball;
  bool has_scored = false;  // the owner of the ball
  bool has_conceded = false;
};

// A game at some time.
struct PlayedSample {
  game::MatchState match;
  int quarter = 0;  // 1 to 3 for the first sample after this quarter of the game, otherwise 0
  std::optional<OwnedBall> ball = {};
  int result = 0;  // of the game; 1: west wins; 0: draw; -1: east wins
};

struct FittedSamples {
  std::vector<SpellSample> spells;
  std::vector<PlayedSample> played;
};

// The samples of this number of batches of games. Throws std::runtime_error if a game fails.
FittedSamples samples_of_games(const std::string& rules, Purpose purpose, std::size_t batches);

}  // namespace autoref::tools
