// A test that stops as soon as the games played so far tell enough.
#pragma once

#include <span>

namespace autoref::runner {

// Two claims about the mean goal difference of a game, and how often the test may be wrong. Its
// unit is the pair of legs: a pair's value is the mean goal difference of its two games.
struct SequentialTest {
  double d0 = 0;        // goals a game; the claim that is kept unless the games speak against it
  double d1 = 1;        // goals a game; above or below d0
  double alpha = 0.05;  // greatest share of tests that accept d1 where d0 is true
  double beta = 0.05;   // greatest share of tests that accept d0 where d1 is true
  int min_pairs = 10;   // no decision before: the spread of a few pairs is anything
  int max_pairs = 200;  // no pair after: then the test ends undecided
};

// Where the log likelihood ratio accepts a claim: d0 at or below the first, d1 at or above the
// other.
double bound_of_d0(const SequentialTest& test);
double bound_of_d1(const SequentialTest& test);

enum class Verdict { kGoOn, kAcceptD0, kAcceptD1, kUndecided };

// What the pairs say, and how many of them it took.
struct SequentialState {
  Verdict verdict = Verdict::kGoOn;
  int pairs = 0;
  double log_likelihood_ratio = 0;  // positive where they speak for d1; infinite where all are d1
};

// Wald's sequential test (Sequential tests of statistical hypotheses, Ann. Math. Stat. 16, 1945)
// in the generalised form for an unknown spread (Li, Liu and Ying, Stat. Sinica 24, 2014), as chess
// programs are tested: the likelihood of normal pair differences x under each claim is taken at
// the variance that fits it best, which makes the log likelihood ratio of n pairs
//
//     n / 2 log(sum of (x - d0)^2 / sum of (x - d1)^2)
//
// and d1 is accepted where that reaches log((1 - beta) / alpha), d0 where it falls to
// log(beta / (1 - alpha)). Wald's bounds hold nearly, not exactly, since the spread is estimated
// and goals are whole numbers: `coverage` (tests/coverage/) measures the true error rates. The
// simpler ratio at one sample variance, n (d1 - d0) (mean - (d0 + d1) / 2) / s^2, errs more: at a
// standard deviation of 4 goals a game in 6.7 % of tests instead of 5.1 %, all else as above.
// Rushton's sequential t test (Biometrika 37, 1950) would be about a difference in standard
// deviations instead of goals.
//
// `pair_differences` are in the pairs' order; those after the verdict do not change it, so that it
// does not depend on how many games were played at once.
//
// Takes for granted that d0 and d1 differ, that alpha and beta are positive and together below 1,
// and that 2 <= min_pairs <= max_pairs.
SequentialState decided_by(const SequentialTest& test, std::span<const double> pair_differences);

}  // namespace autoref::runner
