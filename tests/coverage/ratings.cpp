#include <fmt/format.h>

#include "runner/statistics/bradley_terry.hpp"
#include "runner/statistics/goal_rating.hpp"
#include "runner/statistics/ratings.hpp"
#include "tests/coverage/goals.hpp"
#include "tests/coverage/measured.hpp"

namespace autoref::coverage {
namespace {

using runner::RatedMatchup;
using runner::Rating;
using runner::RatingMethod;

const std::vector<std::string> kTeams = {"a", "b", "c", "d"};
constexpr Means kEqual = {2, 2};

runner::RatedGame rated(const Score& score) {
  const int difference = score.difference();
  return {static_cast<double>(difference), difference > 0 ? 1.0 : difference < 0 ? 0.0 : 0.5};
}

RatedMatchup play_matchup(const std::string& a, const std::string& b, int games,
                          RandomStream& random) {
  RatedMatchup matchup{a, b, {}};
  for (int i = 0; i < games; ++i) {
    matchup.pairs[i / 2].push_back(rated(play(kEqual, random)));
  }
  return matchup;
}

std::vector<RatedMatchup> play_roundrobin(int games, RandomStream& random) {
  std::vector<RatedMatchup> matchups;
  for (std::size_t i = 0; i < kTeams.size(); ++i) {
    for (std::size_t j = i + 1; j < kTeams.size(); ++j) {
      matchups.push_back(play_matchup(kTeams[i], kTeams[j], games, random));
    }
  }
  return matchups;
}

// The proportion of teams whose interval contains 0.
double share_held(const RatingMethod& rate, int games, int trials) {
  RandomStream random(static_cast<std::uint64_t>(games));
  int held = 0;
  for (int i = 0; i < trials; ++i) {
    for (const Rating& rating : runner::ratings_of(play_roundrobin(games, random), rate)) {
      held += rating.interval->low <= 0 && 0 <= rating.interval->high ? 1 : 0;
    }
  }
  return held / static_cast<double>(trials * kTeams.size());
}

}  // namespace

std::vector<Measured> rating_coverage(int trials) {
  std::vector<Measured> all;
  for (const int games : {10, 20, 60}) {
    const std::string where = fmt::format("4 equal teams, {} games per matchup", games);
    all.push_back(
        {"goal rating, " + where, share_held(runner::goal_rating, games, trials), 0.90, 0.98, ""});
    all.push_back({"Bradley-Terry, " + where, share_held(runner::bradley_terry, games, trials),
                   0.90, 0.98, ""});
  }
  return all;
}

}  // namespace autoref::coverage
