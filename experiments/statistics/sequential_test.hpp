// Sequential tests, which stop as soon as the games so far decide them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace autoref::experiments {

// Two hypotheses about the mean goal difference of a game, and the permitted error rates. The unit
// is the pair of legs: a pair's value is the mean goal difference of its two games.
struct SequentialTest {
  double d0 = 0;        // goals per game; the null hypothesis
  double d1 = 1;        // goals per game; the alternative, above or below d0
  double alpha = 0.05;  // maximum probability of accepting d1 if d0 is true
  double beta = 0.05;   // maximum probability of accepting d0 if d1 is true
  int min_pairs = 10;   // no decision before this pair
  int max_pairs = 200;  // the test ends undecided after this pair
};

// Bounds of the log-likelihood ratio: d0 is accepted at or below the first, d1 at or above the
// second.
double bound_of_d0(const SequentialTest& test);
double bound_of_d1(const SequentialTest& test);

// The least variance that the test assumes for the difference of a pair, in squared goals: the
// larger of |d0| and |d1|.
double least_variance_of(const SequentialTest& test);

enum class Verdict { kGoOn, kAcceptD0, kAcceptD1, kUndecided };

// State of the test after the pairs so far.
struct SequentialState {
  Verdict verdict = Verdict::kGoOn;
  int pairs = 0;
  double log_likelihood_ratio = 0;  // positive in favour of d1
};

// Wald's sequential test (Sequential tests of statistical hypotheses, Ann. Math. Stat. 16, 1945) in
// its generalised form for an unknown spread (Li, Liu and Ying, Stat. Sinica 24, 2014), as used to
// test chess programs. The likelihood of n normal pair differences x under each hypothesis d is
// maximised over the variances v that are at least least_variance_of(test):
//
//     log likelihood of d = -n / 2 (log v + q / v),  q = mean of (x - d)^2,  v = max(q, least)
//
// and their difference is the log-likelihood ratio: above the least variance
// n / 2 log(sum of (x - d0)^2 / sum of (x - d1)^2). d1 is accepted when it reaches
// log((1 - beta) / alpha), d0 when it falls to log(beta / (1 - alpha)).
//
// The least variance expresses prior knowledge about goals. If goals are rare and independent
// (Poisson), the difference of a game varies by as much as both teams score together, at least |d|,
// and the mean of two games by half of that. Without a least variance, the first goalless pairs
// would show no spread at all and accept d0 with any certainty, and a stretch with few goals would
// show both a low mean and a low spread. Then, of the tests with d0 = 0 and a true lead of d1 =
// 0.05, 29 to 41 % would err instead of 5 % when one team scores most goals. With half of |d| as
// the least variance, up to 8 % err, and with |d| at most 5.8 %. This costs 9 % to 40 % more pairs
// in those cases and nothing where the differences vary more. `coverage` (tools/coverage/) measures
// the error rates, which Wald's bounds give only approximately, for standard deviations from 0.2 to
// 4 goals and leads from 0.05 to 1.
//
// The simpler ratio with one sample variance, n (d1 - d0) (mean - (d0 + d1) / 2) / s^2, errs more
// often: other things being equal, in 6.7 % of tests instead of 5.1 % for a standard deviation of 4
// goals per game. Rushton's sequential t test (Biometrika 37, 1950) would test a difference in
// standard deviations instead of goals.
//
// `pair_differences` must be in the order of the pairs. Pairs after the verdict do not change it,
// so it does not depend on how many games were played in parallel.
//
// Requires that d0 and d1 differ, that alpha and beta are positive with a sum below 1, and that
// 2 <= min_pairs <= max_pairs.
SequentialState decided_by(const SequentialTest& test, std::span<const double> pair_differences);

// The outcomes of a test of whether one team is better than another.
enum class ThreeWayVerdict : std::uint8_t {
  kGoOn,  // more pairs are needed
  kBetter,
  kWorse,
  kNotShown,   // there is no difference that matters, or none is shown
  kUndecided,  // max_pairs were not enough
};

// "better", "worse", `not_shown`, "undecided", or "none" while more pairs are needed.
std::string name_of(ThreeWayVerdict verdict, std::string_view not_shown);

struct ThreeWayState {
  ThreeWayVerdict verdict = ThreeWayVerdict::kGoOn;
  int pairs = 0;  // number of pairs needed for the verdict; later ones do not count
};

// Runs two sequential tests on the same pairs: one of a mean of 0 against `delta`, the other of a
// mean of 0 against -`delta` (Sobel and Wald, A sequential decision procedure for choosing one of
// three hypotheses concerning the unknown mean of a normal distribution, Ann. Math. Stat. 20,
// 1949). The first test that rejects 0 decides. The verdict is "not shown" if both tests accept 0.
// If the mean is 0, "better" and "worse" each have a probability of at most alpha; if it is delta,
// "better" has at least 1 - beta (approximately, as for a single test).
//
// `test.d0` must be 0; `test.d1` is delta, above 0.
ThreeWayState compared(const SequentialTest& test, std::span<const double> pair_differences);

}  // namespace autoref::experiments
