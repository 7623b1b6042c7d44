// Results of the coverage simulations. Each is printed as one line.
#pragma once

#include <string>
#include <vector>

namespace autoref::coverage {

// A measured proportion of the trials, and the bounds within which the proportion must lie.
struct Measured {
  std::string what;
  double share = 0;
  double least = 0;
  double most = 1;
  std::string remark;

  bool is_good() const { return least <= share && share <= most; }
};

// Coverage of 95 % intervals for Poisson-distributed goals, over 20 and over 60 games. For the mean
// goal difference over pairs of legs, this is Student's interval. For the fraction of decided games
// (without draws) won by team a, these are Wilson's interval, Clopper-Pearson's, and the one chosen
// by proportion_interval().
std::vector<Measured> interval_coverage(int trials);

// Coverage of the intervals of Bradley-Terry strengths and, in a fifth of the trials, of ratings in
// goals, in round robins of equal and unequal teams. The remark contains the lowest and the highest
// coverage of any team's interval, and the fractions of one-sided intervals and of teams without an
// interval.
std::vector<Measured> rating_coverage(int trials);

// Error rates of the sequential test for normally and for Poisson-distributed goals. The leads are
// from 0.05 to 1 goals per game, and the standard deviations of a game from 0.2 to 4; cases that
// need more than 9999 pairs are left out.
std::vector<Measured> sequential_errors(int trials);

// Error rates of comparisons by an anytime interval (experiments/statistics/anytime_interval.hpp),
// and the share of differences that they find, for the same kinds of goals.
std::vector<Measured> comparison_errors(int trials);

}  // namespace autoref::coverage
