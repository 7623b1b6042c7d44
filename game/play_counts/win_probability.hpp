// The probability that a team wins, at any moment of a game: win probability.
//
// Each team's goals in the rest of the game are Poisson distributed, at a rate that is not known.
// Before the game, that rate has a gamma distribution, the same for all teams; every goal and every
// second without one says more about it, which makes the number of goals negative binomially
// distributed. Two approximations are made: expected goals count as a fraction of a goal seen, and
// robots sent off change only the rate from now on. Added to this is what the situation is worth
// (situation_value.hpp).
//
// The result is only shown and is part of neither rows nor hashes, so it need not be the same in
// the last bit on every machine.
//
// The model does not know the teams. Its parameters (win_models.def) were fitted by
// scripts/fit-win-probability to simulated games, separately for each rule book;
// results/reference/win-probability shows how often teams won whose games were left out.
#pragma once

#include <string_view>

#include "soccer/side.hpp"

namespace autoref::game {

// The state of a game before the final whistle, without a shoot-out.
struct MatchState {
  PerSide<int> goals;
  PerSide<double> xg;      // expected goals so far (PlayCounts::xg)
  double played_s = 0;     // time played, by the referee's clock
  double left_s = 0;       // time left to play
  PerSide<int> robots;     // number of robots on the field
  PerSide<double> scores;  // probability that the team scores next, as in SituationValue
};

// Of the result at the end of the playing time; they add up to 1.
struct WinProbability {
  double west = 0;
  double draw = 0;
  double east = 0;
  // The mean share of the points of a win: half a point for a draw.
  double share_of_west() const { return west + draw / 2; }
};

// The model for one rule book.
struct WinModel {
  std::string_view rules;  // name of the rule book
  // The gamma distribution of a team's scoring rate: goals seen before the game, and the time in
  // which they were seen, at least 10 s.
  double prior_goals = 1;
  double prior_s = 100;
  // How much expected goals count instead of goals as evidence of the rate; from 0 to 1.
  double xg_share = 0;
  // The logarithm of the factor by which the rate grows with each robot more than the opponents
  // have.
  double per_robot = 0;

  // More goals than this from now on are left out of the distributions.
  static constexpr int kMostGoals = 80;
  WinProbability probability(const MatchState& match) const;
};

// The model for a rule book, which must have one (asserted).
const WinModel& win_model(std::string_view rules);

}  // namespace autoref::game
