// Results of the simulations, one line each.
#pragma once

#include <string>
#include <vector>

namespace autoref::coverage {

// A proportion of the trials, as measured, and the bounds within which it must be.
struct Measured {
  std::string what;
  double share = 0;
  double least = 0;
  double most = 1;
  std::string remark;

  bool is_good() const { return least <= share && share <= most; }
};

// Coverage of 95 % intervals for Poisson-distributed goals, at 20 and at 60 games: Student's for
// the mean goal difference over pairs of legs, and, for the fraction of decided games (excluding
// draws) that team a wins, Wilson's, Clopper-Pearson's and the interval that proportion_interval()
// selects.
std::vector<Measured> interval_coverage(int trials);

// Coverage of the intervals of Bradley-Terry strengths, and of ratings in goals in a fifth of the
// trials, in round robins of equal and unequal teams. The remark has the coverage of the teams with
// the lowest and the highest one, and the fractions of intervals with one end and of teams without
// an interval.
std::vector<Measured> rating_coverage(int trials);

// Error rates of the sequential test for normal and for Poisson-distributed goals, for leads from
// 0.05 to 1 goals per game and standard deviations of a game from 0.2 to 4, as far as 9999 pairs
// decide them.
std::vector<Measured> sequential_errors(int trials);

}  // namespace autoref::coverage
