// Ratings of versions and the offset between builds, with made-up goal differences.
#include "experiments/analysis/version_ratings.hpp"

#include <gtest/gtest.h>

#include <random>

#include "experiments/analysis/version_tables.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

Group matchup_with(const std::string& team, const std::string& opponent,
                   const DifferenceByPair& differences) {
  Group group;
  group.values = {team, opponent};
  group.pair_differences = differences;
  for (const auto& [pair, difference] : differences)
    group.differences.insert(group.differences.end(), 2, difference);
  return group;
}

std::vector<std::string> names_in(const VersionRatings& ratings) {
  std::vector<std::string> names;
  for (const VersionRating& team : ratings.teams) names.push_back(team.team);
  return names;
}

TEST(VersionRatings, AreSortedByLineAndDate) {
  TeamVersions versions;
  versions.of_teams = {
      {"a", {"2026-03-01", "slow"}}, {"b", {"2026-01-01", "slow"}}, {"c", {"2026-02-01", "fast"}}};
  const VersionRatings ratings = version_ratings(
      versions, {"anchor", "a", "b", "c"},
      {matchup_with("a", "zone", {{1, 4}, {2, 6}}), matchup_with("b", "zone", {{1, 1}, {2, 2}})},
      "1.0", RatedAgainst::kField);
  EXPECT_EQ(names_in(ratings), (std::vector<std::string>{"c", "b", "a", "anchor"}));
  EXPECT_FALSE(ratings.teams[0].rating());
  EXPECT_FALSE(ratings.teams[1].change);  // the first of its line
  EXPECT_DOUBLE_EQ(ratings.teams[2].change.value().mean.value(), 3.5);
  EXPECT_EQ(ratings.teams[2].games, 4);
  EXPECT_FALSE(ratings.offset);
}

TEST(VersionRatings, OfARoundRobinAreRelativeToTheAverageTeam) {
  const std::vector<Group> matchups = {matchup_with("a", "b", {{1, 3}}),
                                       matchup_with("a", "c", {{1, 6}}),
                                       matchup_with("b", "c", {{1, 3}})};
  TeamVersions versions;
  versions.anchors = {"a"};
  const VersionRatings ratings =
      version_ratings(versions, {"a", "b", "c"}, matchups, "1.0", RatedAgainst::kEachOther);
  EXPECT_DOUBLE_EQ(ratings.teams[0].rating().value(), 3);
  EXPECT_DOUBLE_EQ(ratings.teams[1].rating().value(), 0);
  EXPECT_DOUBLE_EQ(ratings.teams[2].rating().value(), -3);
}

TEST(VersionRatings, LeaveOutPairNumbersThatATeamDidNotComplete) {
  const VersionRatings ratings = version_ratings(
      {}, {"a"}, {matchup_with("a", "zone", {{1, 1}, {2, 2}}), matchup_with("a", "bold", {{2, 4}})},
      "1.0", RatedAgainst::kField);
  EXPECT_EQ(ratings.teams[0].by_pair, (DifferenceByPair{{2, 3}}));
}

// Two anchors, and an old version that is not played again.
TeamVersions with_earlier(const DifferenceByPair& one, const DifferenceByPair& two,
                          const DifferenceByPair& old) {
  TeamVersions versions;
  versions.anchors = {"one", "two"};
  versions.earlier = "/earlier";
  versions.taken_over = TakenOver{
      "1.0",
      {{"one", {"1.0", 0, 4, one}}, {"two", {"1.0", 0, 4, two}}, {"old", {"0.9", 0.25, 4, old}}}};
  return versions;
}

VersionRatings with_offset(const TeamVersions& versions, const DifferenceByPair& one,
                           const DifferenceByPair& two) {
  return version_ratings(versions, {"one", "two"},
                         {matchup_with("one", "zone", one), matchup_with("two", "zone", two)},
                         "2.0", RatedAgainst::kField);
}

TEST(BuildOffset, IsTheMeanChangeOfTheAnchors) {
  const VersionRatings ratings = with_offset(
      with_earlier({{1, 1}, {2, 2}, {3, 9}}, {{1, 0}, {2, 0}}, {{1, 5}, {2, 7}, {3, 0}}),
      {{1, 2}, {2, 4}, {4, 9}}, {{1, 3}, {2, 4}});
  const BuildOffset& offset = ratings.offset.value();
  EXPECT_EQ(offset.by_pair, (DifferenceByPair{{1, 2}, {2, 3}}));  // pairs that both have in both
  EXPECT_EQ(offset.anchors, 2U);
  const VersionRating& old = ratings.teams[0];
  EXPECT_EQ(old.team, "old");
  EXPECT_EQ(old.by_pair, (DifferenceByPair{{1, 7}, {2, 10}}));
  EXPECT_DOUBLE_EQ(old.offset.value(), 0.25 + 2.5);
}

TEST(BuildOffset, OfATeamIsTheMeanOverThePairNumbersOfItsRating) {
  const VersionRatings ratings =
      with_offset(with_earlier({{1, 0}, {2, 0}}, {{1, 0}, {2, 0}}, {{2, 5}}), {{1, 1}, {2, 4}},
                  {{1, 1}, {2, 4}});
  const VersionRating& old = ratings.teams[0];
  EXPECT_EQ(old.by_pair, (DifferenceByPair{{2, 9}}));
  EXPECT_DOUBLE_EQ(old.offset.value(), 0.25 + 4);
}

TEST(BuildOffset, IsNotWantedBeforeTheFirstGameIfOnlyAnchorsAreTakenOver) {
  TeamVersions versions = with_earlier({{1, 1}}, {{1, 1}}, {});
  versions.taken_over.value().teams.erase("old");
  EXPECT_FALSE(version_ratings(versions, {"one", "two"}, {}, "", RatedAgainst::kField).offset);
  EXPECT_TRUE(version_ratings(versions, {"one", "two"}, {}, "2.0", RatedAgainst::kField).offset);
}

TEST(BuildOffset, SaysIfItIsNotKnownYet) {
  const VersionRatings ratings =
      with_offset(with_earlier({{1, 1}}, {{1, 1}}, {{1, 1}}), {{2, 1}}, {{2, 1}});
  EXPECT_FALSE(ratings.teams[0].rating());
  EXPECT_TRUE(has(io::text_of(versions_table(ratings), 1000), "is not known"));
}

TEST(BuildOffset, NamesAnchorsThatChangeDifferently) {
  DifferenceByPair zero;
  DifferenceByPair up;
  for (int pair = 1; pair <= 20; ++pair) {
    zero[pair] = 0;
    up[pair] = 2 + 0.1 * (pair % 3);
  }
  const VersionRatings alike = with_offset(with_earlier(zero, zero, zero), up, up);
  EXPECT_TRUE(alike.offset.value().deviations.empty());
  const VersionRatings ratings = with_offset(with_earlier(zero, zero, zero), up, zero);
  ASSERT_EQ(ratings.offset.value().deviations.size(), 1U);
  EXPECT_TRUE(has(io::text_of(versions_table(ratings), 1000), "The anchors changed differently"));
}

// Made-up ratings: noise that two builds share because of the same seeds, and noise of their own.
class MadeUpOffset {
 public:
  static constexpr double kTrue = 0.7;
  static constexpr int kMadeUpPairs = 12;

  VersionRatings next() {
    std::array<DifferenceByPair, 5> made_up;
    for (int pair = 1; pair <= kMadeUpPairs; ++pair) {
      const double shared = normal_(random_);  // by all teams
      for (DifferenceByPair& one : made_up) one[pair] = shared + normal_(random_);
      for (const std::size_t now : {3, 4}) made_up[now][pair] += kTrue;
    }
    return with_offset(with_earlier(made_up[0], made_up[1], made_up[2]), made_up[3], made_up[4]);
  }

 private:
  std::mt19937 random_{2026};
  std::normal_distribution<double> normal_{0, 1};
};

TEST(BuildOffset, HasAnIntervalThatContainsTheTruthInNineteenOfTwentyExperiments) {
  constexpr int kExperiments = 2000;
  MadeUpOffset made_up;
  int covered = 0;
  int old_covered = 0;
  int deviating = 0;
  const auto contains = [](const Interval& interval, double truth) {
    return interval.low <= truth && truth <= interval.high;
  };
  for (int i = 0; i < kExperiments; ++i) {
    const VersionRatings ratings = made_up.next();
    const BuildOffset& offset = ratings.offset.value();
    covered += contains(mean_interval(values_of(offset.by_pair)).value(), MadeUpOffset::kTrue);
    old_covered += contains(ratings.teams[0].interval().value(), MadeUpOffset::kTrue);
    deviating += offset.deviations.empty() ? 0 : 1;
  }
  // Four standard errors of a share of 5 % are 2 %.
  EXPECT_NEAR(covered, 0.95 * kExperiments, 0.02 * kExperiments);
  EXPECT_NEAR(old_covered, 0.95 * kExperiments, 0.02 * kExperiments);
  EXPECT_NEAR(deviating, 0.05 * kExperiments, 0.02 * kExperiments);
}

TEST(StoredRatings, ReadBackWhatWasWritten) {
  const VersionRatings ratings =
      with_offset(with_earlier({{1, 1}, {2, 2}}, {{1, 0}, {2, 0}}, {{1, 1.0 / 3}, {2, 7}}),
                  {{1, 2}, {2, 4}}, {{1, 3}, {2, 4}});
  const auto stored = stored_ratings(versions_csv(ratings.teams), version_pairs_csv(ratings.teams));
  ASSERT_EQ(stored.size(), 3U);
  EXPECT_TRUE(stored.at("old").is_taken_over);
  EXPECT_EQ(stored.at("old").team.build, "0.9");
  EXPECT_EQ(stored.at("old").team.by_pair, ratings.teams[0].by_pair);
  EXPECT_DOUBLE_EQ(stored.at("old").team.offset, 2.75);
  EXPECT_FALSE(stored.at("one").is_taken_over);
  EXPECT_EQ(stored.at("one").team.build, "2.0");
}

TEST(StoredRatings, RefuseOtherTexts) {
  EXPECT_THROW(stored_ratings("team,build\nv1,1.0\n", ""), std::invalid_argument);
  EXPECT_THROW(stored_ratings("team,build,games,offset\nv1,1.0,2\n", ""), std::invalid_argument);
  EXPECT_THROW(stored_ratings("team,build,games,offset\nv1,1.0,2,\n", "team,pair,rating\nv2,1,2\n"),
               std::invalid_argument);
}

TEST(StoredRatings, RefuseNumbersThatAreNotWholeOrOutOfRange) {
  const auto read = [](const std::string& games, const std::string& pair) {
    stored_ratings("team,build,games,offset\nv1,1.0," + games + ",\n",
                   "team,pair,rating\nv1," + pair + ",2\n");
  };
  EXPECT_NO_THROW(read("2", "9999"));
  for (const char* games : {"-1", "2.5", "1e300"})
    EXPECT_THROW(read(games, "1"), std::invalid_argument) << games;
  for (const char* pair : {"0", "1.5", "10000", "1e300"})
    EXPECT_THROW(read("2", pair), std::invalid_argument) << pair;
}

}  // namespace
}  // namespace autoref::experiments
