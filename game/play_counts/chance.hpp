// How good a chance a shot is: the probability that it scores, estimated when the ball leaves the
// robot.
//
// There are two estimates. The first does not know where the shot is aimed (xG, expected goals), so
// it measures the chance that the team created. The second knows the shot's path (xGOT, expected
// goals on target), so their difference measures the aim, and the difference between goals and xGOT
// measures the defence.
//
// Both are logistic models with an upper limit, because even the best shot may miss or hit a robot.
// scripts/fit-chances fitted the limits and coefficients (chances.def) to shots in simulated games,
// separately for each rule book. results/reference/chances shows how well they hold for teams whose
// games were left out.
#pragma once

#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <string_view>

#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::game {

// The path of a shot up to the opponents' goal line.
struct ShotPath {
  Vec2 crossing_m{0, 0};      // where it crosses the goal line
  double time_s = 0;          // when, after the kick
  bool is_on_target = false;  // whether it leads between the posts and under the bar
};

// Distances to opponents are at most this, also if there are none.
inline constexpr double kNoOpponent_m = 5.0;

// The angle in rad, seen from the ball, of the widest part of the opponents' goal that no robot
// covers. `robot`, the shooter, does not count.
double widest_opening_rad(RobotId robot, const Vec2& ball_m, const sim::WorldState& now,
                          const Field& field);

// What is known about a shot when it is taken. The keeper is the opponent nearest to the centre of
// its goal. Distances are measured to robots' centres.
struct ShotSituation {
  double distance_m = 0;                // from the ball to the centre of the opponents' goal
  double opening_rad = 0;               // widest_opening_rad() from the kicker
  double time_s = 0;                    // distance_m divided by the speed of the kick
  double keeper_m = kNoOpponent_m;      // from the keeper to the segment from ball to goal centre
  double keeper_out_m = kNoOpponent_m;  // from the keeper to its goal's centre
  double keeper_mps = 0;                // the keeper's speed
  double opponent_m = kNoOpponent_m;    // from the ball to the nearest opponent
  bool is_chip = false;
  ShotPath path;
  double keeper_to_path_m = kNoOpponent_m;  // from the keeper to the shot's path
  double others_to_path_m = kNoOpponent_m;  // from the nearest other robot, of either team, to it
};

// `now` is the world at the end of the kick's frame.
ShotSituation shot_situation(const sim::Touch& kick, const ShotPath& path,
                             const sim::WorldState& now, const Field& field);

// The features of the two models; the first one of each is always 1.
inline constexpr std::size_t kChanceFeatures = 9;
inline constexpr std::size_t kTargetFeatures = 12;
std::array<double, kChanceFeatures> chance_features(const ShotSituation& situation);
std::array<double, kTargetFeatures> target_features(const ShotSituation& situation);

// A logistic model's probability.
template <std::size_t kCount>
double probability(const std::array<double, kCount>& coefficients,
                   const std::array<double, kCount>& features) {
  const double score =
      std::inner_product(coefficients.begin(), coefficients.end(), features.begin(), 0.0);
  return 1 / (1 + exponential(-score));
}

// A logistic model whose probability is multiplied by an upper limit.
template <std::size_t kCount>
struct LimitedModel {
  double upper_limit = 1;  // from 0 to 1
  std::array<double, kCount> coefficients{};

  double probability(const std::array<double, kCount>& features) const {
    return upper_limit * game::probability(coefficients, features);
  }
};

// The models for one rule book.
struct ChanceModel {
  std::string_view rules;                      // name of the rule book
  LimitedModel<kChanceFeatures> without_path;  // of the features of all shots
  LimitedModel<kTargetFeatures> with_path;     // of those of shots on target

  // The probability, from 0 to 1, that the shot scores: xG.
  double chance(const ShotSituation& situation) const;
  // The same, knowing its path: xGOT. 0 for a shot that is not on target.
  double chance_on_target(const ShotSituation& situation) const;
};

// The models of all rule books.
std::span<const ChanceModel> chance_models();

// The model for a rule book, which must have one (asserted).
const ChanceModel& chance_model(std::string_view rules);

}  // namespace autoref::game
