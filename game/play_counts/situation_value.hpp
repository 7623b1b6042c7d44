// What a situation is worth: the probabilities that the current spell of play, or the next one if
// play is stopped, ends with a goal for the team that has the ball, or with one against it.
//
// Two logistic models, except while a shot is on its way, which first has its own chance. The
// coefficients (situation_values.def) were fitted by scripts/fit-win-probability to simulated
// games, separately for each rule book. results/reference/win-probability shows how well they hold
// for a team whose games were left out.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "game/play_counts/chance.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

// Who has the ball.
struct BallOwner {
  Side team = Side::kWest;
  bool is_restart = false;  // whether the team will take a restart; the ball may not be placed yet
  bool is_penalty = false;  // whether the restart is a penalty kick
  // The chance, knowing its path, of the team's shot that is on its way (Shot::chance_on_target).
  std::optional<double> shot_chance = {};
};

inline constexpr std::size_t kValueFeatures = 10;

// The features of a situation as the owner of the ball sees it, in this order. They are the same on
// either half. For a restart, those marked with * are 0, since the ball may not be placed yet.
//
//   1
//   how far forward the ball is, as a share of half the field's length *
//   1 for a restart, otherwise 0
//   1 for a penalty kick, otherwise 0
//   closeness of the ball to the opponents' goal, from 0 to 1 (exponential, scale 2 m) *
//   root of the widest open angle of the goal from the ball, in rad (widest_opening_rad()) *
//   closeness of the nearest opponent to the ball (exponential, scale 0.3 m) *
//   closeness of the owner's nearest robot to the ball (likewise) *
//   the ball's forward speed divided by 4 m/s, at most 1 in size *
//   how many more robots the owner has, at most 3 in size
std::array<double, kValueFeatures> value_features(const BallOwner& owner,
                                                  const sim::WorldState& now, const Field& field);

struct SituationValue {
  double scores = 0;    // probability of a goal by the owner of the ball, from 0 to 1
  double concedes = 0;  // probability of a goal by the opponents
};

// The models for one rule book.
struct ValueModel {
  std::string_view rules;  // name of the rule book
  std::array<double, kValueFeatures> scores{};
  std::array<double, kValueFeatures> concedes{};

  // `shot_chance` as in BallOwner.
  SituationValue value(const std::array<double, kValueFeatures>& features,
                       std::optional<double> shot_chance) const;
};

// The model for a rule book, which must have one (asserted).
const ValueModel& value_model(std::string_view rules);

}  // namespace autoref::game
