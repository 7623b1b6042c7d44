// Round robins of unequal teams, with known true ratings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/statistics/rated_games.hpp"
#include "soccer/random.hpp"

namespace autoref::coverage {

// Plays a game of team i against team j; teams are numbered from 0.
using PlayGame = std::function<experiments::RatedGame(std::size_t, std::size_t, RandomStream&)>;

struct League {
  std::string name;
  PlayGame play;
  std::vector<double> goals;      // true ratings in goals; empty if games have no goals
  std::vector<double> strengths;  // true Bradley-Terry strengths
};

// Games of the Bradley-Terry model with draws: the probability of a draw is 2 p (1 - p) times
// `draws` (0 to 1), where p is the probability of a win, with a draw counted as half a win.
// `strengths` sum to zero.
League model_league(const std::string& name, const std::vector<double>& strengths, double draws);

// Games with Poisson-distributed goals: i scores 2 exp(skill of i - skill of j) against j. The true
// ratings are those that follow from the expected totals of so many games that the regularisation
// penalty has no effect.
League poisson_league(const std::string& name, const std::vector<double>& skills);

// A round robin with `pairs` pairs of legs in each matchup; all legs are independent.
std::vector<experiments::RatedMatchup> play_round_robin(const League& league, int pairs,
                                                        RandomStream& random);

}  // namespace autoref::coverage
