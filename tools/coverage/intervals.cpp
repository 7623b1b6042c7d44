#include <fmt/format.h>

#include <boost/math/distributions/poisson.hpp>

#include "experiments/statistics/interval.hpp"
#include "tools/coverage/goals.hpp"
#include "tools/coverage/measured.hpp"

namespace autoref::coverage {
namespace {

using experiments::Interval;

// How many of the intervals contained the true value.
struct Tally {
  int held = 0;
  int trials = 0;

  void add(const std::optional<Interval>& interval, double truth) {
    if (!interval) return;
    ++trials;
    if (interval->low <= truth && truth <= interval->high) ++held;
  }
  double share() const { return static_cast<double>(held) / trials; }
};

struct Tallies {
  Tally student;
  Tally wilson;
  Tally clopper_pearson;
  Tally picked;
};

// The true probability that team a wins a decided game.
double share_of_a(const Means& means) {
  constexpr int kMostGoals = 100;
  const boost::math::poisson of_a(means.a);
  const boost::math::poisson of_b(means.b);
  double wins = 0;
  double losses = 0;
  for (int goals = 1; goals <= kMostGoals; ++goals) {
    wins += pdf(of_a, goals) * cdf(of_b, goals - 1);
    losses += pdf(of_b, goals) * cdf(of_a, goals - 1);
  }
  return wins / (wins + losses);
}

void add(Tallies& tallies, const Means& means, double share, const std::vector<Score>& scores) {
  tallies.student.add(experiments::mean_interval(pair_differences(scores)), means.a - means.b);
  int wins = 0;
  int decided = 0;
  for (const Score& score : scores) {
    wins += score.difference() > 0 ? 1 : 0;
    decided += score.difference() != 0 ? 1 : 0;
  }
  tallies.wilson.add(experiments::wilson_interval(wins, decided), share);
  tallies.clopper_pearson.add(experiments::clopper_pearson_interval(wins, decided), share);
  tallies.picked.add(experiments::proportion_interval(wins, decided), share);
}

std::vector<Measured> coverage_at(const Means& means, int games, int trials) {
  RandomStream random(static_cast<std::uint64_t>(games));
  const double share = share_of_a(means);
  Tallies tallies;
  for (int i = 0; i < trials; ++i) add(tallies, means, share, play(means, games, random));
  const std::string where = fmt::format("means {} and {}, {} games", means.a, means.b, games);
  const std::string truth = fmt::format("true share {:.3f}", share);
  return {{"Student, " + where, tallies.student.share(), 0.93, 0.97, ""},
          {"Wilson, " + where, tallies.wilson.share(), 0.90, 1, truth},
          {"Clopper-Pearson, " + where, tallies.clopper_pearson.share(), 0.95, 1, truth},
          {"picked, " + where, tallies.picked.share(), 0.90, 1, truth}};
}

}  // namespace

std::vector<Measured> interval_coverage(int trials) {
  std::vector<Measured> all;
  for (const int games : {20, 60}) {
    for (const Means& means :
         {Means{1, 1}, Means{2, 2}, Means{4, 4}, Means{2, 1}, Means{4, 2}, Means{4, 1}}) {
      for (Measured& measured : coverage_at(means, games, trials)) {
        all.push_back(std::move(measured));
      }
    }
  }
  // A case of few games with few goals. If all pairs have the same difference, Student's interval
  // does not exist; the other intervals are valid.
  for (const int games : {4, 10}) {
    for (const Means& means : {Means{0.3, 0.3}, Means{1, 1}, Means{2, 1}}) {
      Measured student = coverage_at(means, games, trials).front();
      student.most = 1;
      all.push_back(std::move(student));
    }
  }
  return all;
}

}  // namespace autoref::coverage
