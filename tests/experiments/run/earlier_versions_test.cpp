// Experiments that take over ratings of an earlier folder, which another build may have played.
#include "experiments/run/earlier_versions.hpp"

#include <gtest/gtest.h>

#include "experiments/analysis/version_tables.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/result_folder.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_versions.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

class EarlierFolder : public testing::Test {
 protected:
  ExperimentReport play(Scenario scenario, const std::string& folder, const std::string& build,
                        AddedGoals added = {}) {
    take_over_versions(scenario, build);
    ExperimentOptions options = fake_options(parent_ / folder);
    options.build = build;
    options.play = game_of_build(std::move(added));
    return run_experiment(scenario, options);
  }
  // Adds a version, and names the earlier folder.
  Scenario next(Scenario scenario, const std::string& earlier, const std::string& name = "v3",
                int robots = 7) const {
    const VersionedTeams teams = scenario.experiment().versioned_teams().value();
    (*teams.rated)[name].robots = robots;
    teams.versions->of_teams[name] = {"2026-05-0" + name.substr(1), ""};
    teams.versions->earlier = parent_ / earlier;
    return scenario;
  }
  std::string refusal(Scenario scenario, const std::string& build = "2.0") const {
    try {
      take_over_versions(scenario, build);
    } catch (const io::InputError& error) {
      return error.what();
    }
    return "";
  }
  static VersionRating rating_of(const ExperimentReport& report, const std::string& team) {
    for (const VersionRating& rating : report.results.versions)
      if (rating.team == team) return rating;
    ADD_FAILURE() << team;
    return {};
  }

  TemporaryFolder parent_;
};

// Each team against zone, 4 pairs of 2 legs.
constexpr int kGamesOfATeam = 8;

TEST_F(EarlierFolder, OfTheSameBuildGivesItsGames) {
  EXPECT_EQ(play(versioned_gauntlet(), "first", "1.0").played, 3 * kGamesOfATeam);
  const ExperimentReport report = play(next(versioned_gauntlet(), "first"), "second", "1.0");
  EXPECT_EQ(report.played, kGamesOfATeam);
  EXPECT_EQ(report.games, 4 * kGamesOfATeam);
  EXPECT_FALSE(rating_of(report, "v1").offset);
}

TEST_F(EarlierFolder, OfAnotherBuildGivesRatingsPlusTheOffset) {
  const ExperimentReport first = play(versioned_gauntlet(), "first", "1.0");
  // The anchor scores two goals more per game than in build 1.0, zone as many as before.
  const ExperimentReport report =
      play(next(versioned_gauntlet(), "first"), "second", "2.0", {{6, 2}});
  EXPECT_EQ(report.played, 2 * kGamesOfATeam);  // those of basic and v3
  const VersionRating v1 = rating_of(report, "v1");
  EXPECT_DOUBLE_EQ(v1.offset.value(), 2);
  EXPECT_DOUBLE_EQ(v1.rating().value(), rating_of(first, "v1").rating().value() + 2);
  EXPECT_EQ(v1.build, "1.0");
  EXPECT_EQ(v1.games, kGamesOfATeam);
  EXPECT_EQ(rating_of(report, "v3").build, "2.0");
  EXPECT_FALSE(rating_of(report, "basic").offset);
}

TEST_F(EarlierFolder, IsNotNeededOnceTheExperimentHasBegun) {
  play(versioned_gauntlet(), "first", "1.0");
  play(next(versioned_gauntlet(), "first"), "second", "2.0", {{6, 2}});
  const std::string before = content_of(parent_ / "second" / kVersionsFile);
  fs::remove_all(parent_ / "first");
  const ResultFolder folder = open_results(parent_ / "second");
  EXPECT_TRUE(folder.is_complete());
  write_results(folder.path, folder.scenario, folder.format, folder.completed_games.done);
  EXPECT_EQ(content_of(parent_ / "second" / kVersionsFile), before);
}

TEST_F(EarlierFolder, CanHaveTakenOverRatingsItself) {
  const ExperimentReport first = play(versioned_gauntlet(), "first", "1.0");
  play(next(versioned_gauntlet(), "first"), "second", "2.0", {{6, 2}});
  Scenario third = next(next(versioned_gauntlet(), "first"), "second", "v4", 8);
  const ExperimentReport report = play(third, "third", "3.0", {{6, 5}});
  EXPECT_EQ(report.played, 2 * kGamesOfATeam);  // those of basic and v4
  EXPECT_DOUBLE_EQ(rating_of(report, "v1").offset.value(), 2 + 3);
  EXPECT_DOUBLE_EQ(rating_of(report, "v1").rating().value(),
                   rating_of(first, "v1").rating().value() + 5);
  EXPECT_EQ(rating_of(report, "v1").build, "1.0");
  EXPECT_DOUBLE_EQ(rating_of(report, "v3").offset.value(), 3);
  EXPECT_EQ(rating_of(report, "v3").build, "2.0");
}

TEST_F(EarlierFolder, OfTheSameBuildKeepsTheRatingsThatItTookOver) {
  play(versioned_gauntlet(), "first", "1.0");
  const ExperimentReport second =
      play(next(versioned_gauntlet(), "first"), "second", "2.0", {{6, 2}});
  Scenario third = next(next(versioned_gauntlet(), "first"), "second", "v4", 8);
  const ExperimentReport report = play(third, "third", "2.0", {{6, 2}});
  EXPECT_EQ(report.played, kGamesOfATeam);  // those of v4; those of basic and v3 are reused
  EXPECT_DOUBLE_EQ(rating_of(report, "v1").rating().value(),
                   rating_of(second, "v1").rating().value());
  EXPECT_DOUBLE_EQ(rating_of(report, "v1").offset.value(), 2);
}

TEST_F(EarlierFolder, OfARoundRobinKeepsDifferencesBetweenTeams) {
  const ExperimentReport first = play(versioned_robin(), "first", "1.0");
  // Nothing changes but the average team.
  const ExperimentReport report = play(next(versioned_robin(), "first"), "second", "2.0");
  EXPECT_EQ(report.played, 3 * kGamesOfATeam);  // basic, calm and v3 against each other
  const auto difference = [](const ExperimentReport& its, const char* one, const char* other) {
    return rating_of(its, one).rating().value() - rating_of(its, other).rating().value();
  };
  EXPECT_NEAR(difference(report, "v2", "v1"), difference(first, "v2", "v1"), 1e-9);
  for (const Standing& standing : report.results.standings)
    EXPECT_NEAR(rating_of(report, standing.team).rating().value(), standing.goals.value, 1e-9);
}

TEST_F(EarlierFolder, ComparesVersionsPairByPair) {
  play(versioned_gauntlet(), "first", "1.0");
  const ExperimentReport report = play(next(versioned_gauntlet(), "first"), "second", "2.0");
  // v2 has one robot more than v1, v3 three more than v2; all played with the same seeds.
  EXPECT_FALSE(rating_of(report, "v1").change);
  EXPECT_DOUBLE_EQ(rating_of(report, "v2").change.value().mean.value(), 1);
  EXPECT_DOUBLE_EQ(rating_of(report, "v3").change.value().mean.value(), 3);
  EXPECT_EQ(rating_of(report, "v3").change.value().pairs, 4U);
}

TEST_F(EarlierFolder, LeavesChangedTeamsToBePlayedAgain) {
  play(versioned_gauntlet(), "first", "1.0");
  Scenario second = next(versioned_gauntlet(), "first");
  second.as<Gauntlet>()->challengers["v1"].robots = 2;
  EXPECT_EQ(play(second, "second", "2.0").played, 3 * kGamesOfATeam);
}

TEST_F(EarlierFolder, GivesNoRatingsOfProgramsWithUnknownFiles) {
  Scenario first = versioned_gauntlet();
  for (const char* name : {"v1", "v2"})
    first.as<Gauntlet>()->challengers[name].program.command = {"mine"};
  first.as<Gauntlet>()->challengers["v2"].files_hash = "1";
  play(first, "first", "1.0");
  EXPECT_EQ(play(next(first, "first"), "second", "2.0").played, 3 * kGamesOfATeam);  // all but v2
  first.as<Gauntlet>()->challengers["v2"].files_hash = "2";
  EXPECT_EQ(play(next(first, "first"), "third", "2.0").played, 4 * kGamesOfATeam);
}

TEST_F(EarlierFolder, NeedsAnAnchorInBoth) {
  play(versioned_gauntlet(), "first", "1.0");
  Scenario second = next(versioned_gauntlet(), "first");
  second.as<Gauntlet>()->versions.anchors = {};
  EXPECT_TRUE(has(refusal(second), "no anchor is in both")) << refusal(second);
  EXPECT_TRUE(has(refusal(second), "anchors: [basic] (any of basic, v1, v2)"));
  EXPECT_EQ(refusal(second, "1.0"), "");
  second.as<Gauntlet>()->versions.anchors = {"v3"};
  EXPECT_TRUE(has(refusal(second), "no anchor is in both"));
}

TEST_F(EarlierFolder, OfTheSameBuildNeedsAnAnchorIfItTookOverRatings) {
  play(versioned_gauntlet(), "first", "1.0");
  play(next(versioned_gauntlet(), "first"), "second", "2.0");
  Scenario third = next(next(versioned_gauntlet(), "first"), "second", "v4", 8);
  third.as<Gauntlet>()->versions.anchors = {};
  const std::string message = refusal(third, "2.0");
  EXPECT_TRUE(has(message, "took over ratings of an earlier build")) << message;
  EXPECT_TRUE(has(message, "list an anchor that is in both")) << message;
}

TEST_F(EarlierFolder, NamesAChangedAnchor) {
  play(versioned_gauntlet(), "first", "1.0");
  Scenario second = next(versioned_gauntlet(), "first");
  second.as<Gauntlet>()->challengers["basic"].robots = 2;
  const std::string message = refusal(second);
  EXPECT_TRUE(has(message, "the anchor 'basic' is not the same team there")) << message;
  EXPECT_TRUE(has(message, "challengers.basic.robots is 2 here and 6 there")) << message;
}

TEST_F(EarlierFolder, OfTheSameBuildMayHaveOtherAnchors) {
  play(versioned_gauntlet(), "first", "1.0");
  Scenario second = next(versioned_gauntlet(), "first");
  second.as<Gauntlet>()->challengers["basic"].robots = 2;
  EXPECT_EQ(play(second, "second", "1.0").played, 2 * kGamesOfATeam);  // those of basic and v3
}

TEST_F(EarlierFolder, NamesAChangedField) {
  play(versioned_gauntlet(), "first", "1.0");
  Scenario second = next(versioned_gauntlet(), "first");
  second.as<Gauntlet>()->teams["zone"].robots = 2;
  EXPECT_TRUE(has(refusal(second), "'zone' of the field is not the same team")) << refusal(second);
  second = next(versioned_gauntlet(), "first");
  second.as<Gauntlet>()->teams.clear();
  second.as<Gauntlet>()->teams["bold"];
  EXPECT_TRUE(has(refusal(second), "'bold' of the field is not the same team")) << refusal(second);
}

TEST_F(EarlierFolder, HasTheSameSeedAndKind) {
  play(versioned_gauntlet(), "first", "1.0");
  Scenario second = next(versioned_gauntlet(), "first");
  second.as<Gauntlet>()->seed = 3;
  EXPECT_TRUE(has(refusal(second), "seed is 3 here and 2014 there")) << refusal(second);
  EXPECT_TRUE(has(refusal(next(versioned_robin(), "first")), "holds a gauntlet"));
}

TEST_F(EarlierFolder, FollowsRatings) {
  EXPECT_TRUE(has(refusal(next(versioned_gauntlet(), "nothing")), "holds no results"));
  Scenario plain = versioned_gauntlet();
  plain.as<Gauntlet>()->versions = {};
  play(plain, "plain", "1.0");
  EXPECT_TRUE(has(refusal(next(versioned_gauntlet(), "plain")), "has no versions.csv"));
  play(versioned_gauntlet(), "first", "1.0");
  write_content(parent_ / "first" / kVersionPairsFile, "team,pair,rating\nv1,x,2\n");
  EXPECT_TRUE(has(refusal(next(versioned_gauntlet(), "first")), "expected a whole number"));
}

TEST_F(EarlierFolder, IsNotTheResultsFolder) {
  play(versioned_gauntlet(), "first", "1.0");
  EXPECT_THROW(play(next(versioned_gauntlet(), "first"), "first", "1.0"), io::InputError);
}

TEST_F(EarlierFolder, LeavesAtLeastTwoTeamsOfARoundRobin) {
  play(versioned_robin(), "first", "1.0");
  Scenario second = versioned_robin();
  second.as<RoundRobin>()->versions.earlier = parent_ / "first";
  second.as<RoundRobin>()->versions.anchors = {"basic"};
  EXPECT_TRUE(has(refusal(second), "only one team would play")) << refusal(second);
}

}  // namespace
}  // namespace autoref::experiments
