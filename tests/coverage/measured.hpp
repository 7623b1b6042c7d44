// What the simulations found, line by line.
#pragma once

#include <string>
#include <vector>

namespace autoref::coverage {

// A share of the trials, and between which bounds it has to be.
struct Measured {
  std::string what;
  double share = 0;
  double least = 0;
  double most = 1;
  std::string remark;

  bool is_good() const { return least <= share && share <= most; }
};

// How often 95 % intervals hold the truth, with goals that are Poisson: Student's for the mean goal
// difference over pairs of legs, and, for a's share of the decided games (draws left out),
// Wilson's, Clopper's and Pearson's, and the one that proportion_interval() picks. At 20 and at 60
// games.
std::vector<Measured> interval_coverage(int trials);

// How often the bootstrap intervals of ratings hold the truth, in a round robin of four equal
// teams.
std::vector<Measured> rating_coverage(int trials);

// How often the sequential test (d0 = 0, d1 = 1, alpha = beta = 0.05) takes the wrong side.
std::vector<Measured> sequential_errors(int trials);

}  // namespace autoref::coverage
