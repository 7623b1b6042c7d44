// Gauntlets, with made-up games.
#include "experiments/kinds/gauntlet/gauntlet.hpp"

#include <gtest/gtest.h>

#include <map>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/fields.hpp"
#include "tests/experiments/reading/mistake.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

// team0 and team1 challenge team2 and team3. No two teams have the same number of robots.
Gauntlet first_gauntlet() {
  Gauntlet gauntlet;
  gauntlet.challengers["team0"].robots = 6;
  gauntlet.challengers["team1"].robots = 5;
  gauntlet.teams["team2"].robots = 4;
  gauntlet.teams["team3"].robots = 3;
  gauntlet.pairs = 2;
  gauntlet.seed = 2014;
  return gauntlet;
}

TEST(Gauntlet, PairsEachChallengerWithEachTeamOfTheField) {
  const std::vector<Matchup> expected = {
      {"team0", "team2"}, {"team0", "team3"}, {"team1", "team2"}, {"team1", "team3"}};
  EXPECT_EQ(matchups_of(first_gauntlet()), expected);
}

TEST(Gauntlet, HasTheGamesOfARoundRobin) {
  std::map<std::string, std::uint64_t> robins;
  for (const ScheduledGame& game : small_roundrobin({6, 5, 4, 3}).experiment().games()) {
    robins[game.id] = game::configuration_hash(game.settings.combined());
  }
  const std::vector<ScheduledGame> games = first_gauntlet().games();
  EXPECT_EQ(games.size(), 16U);
  for (const ScheduledGame& game : games) {
    EXPECT_EQ(robins.at(game.id), game::configuration_hash(game.settings.combined())) << game.id;
  }
}

TEST(Gauntlet, MakesTheChallengerTeamAWhateverItsName) {
  Gauntlet gauntlet;
  gauntlet.challengers["zone"];
  gauntlet.teams["bold"];
  EXPECT_EQ(gauntlet.games().front().id, "zone~bold-p0001-1");
  EXPECT_EQ(gauntlet.games().front().team_a, "zone");
}

TEST(GauntletRun, RanksOnlyTheChallengersAndDoesNotRateThem) {
  const TemporaryFolder folder;
  const ExperimentReport report =
      run_experiment({"A test.", first_gauntlet()}, fake_options(folder.path()));
  EXPECT_EQ(line_count(content_of(folder / "summary.csv")), 5);
  ASSERT_EQ(report.results.standings.size(), 2U);
  EXPECT_EQ(report.results.standings[0].games(), 8);
  const std::string standings = content_of(folder / "standings.csv");
  EXPECT_EQ(line_count(standings), 3);
  EXPECT_EQ(standings.find("rating"), std::string::npos);
}

TEST(GauntletRun, PlaysOnlyTheNewGamesWhenAChallengerIsAdded) {
  const TemporaryFolder folder;
  Gauntlet gauntlet = first_gauntlet();
  run_experiment({"A test.", gauntlet}, fake_options(folder.path()));
  gauntlet.challengers["team4"].robots = 2;
  EXPECT_EQ(run_experiment({"A test.", gauntlet}, fake_options(folder.path())).played, 8);
}

TEST(ChangesBetween, NamesTheChallengerThatDiffers) {
  Gauntlet other = first_gauntlet();
  other.challengers["team1"].robots = 4;
  other.challengers["team5"].robots = 4;
  EXPECT_EQ(changes_between(first_gauntlet(), other),
            "challengers.team1.robots is 5 here and 4 there");
}

TEST(EffectiveConfiguration, OfAGauntletReadsBackEqual) {
  const std::string text = effective_text({"A test.", first_gauntlet()});
  EXPECT_EQ(effective_text(read_scenario_text(text, "x.yaml")), text);
}

const std::string kGauntletTop = "schema: 1\nkind: gauntlet\npairs: 2\nseed: 7\n";

class WrongGauntlet : public testing::TestWithParam<Mistake> {};

TEST_P(WrongGauntlet, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongGauntlet,
    testing::Values(
        Mistake{"NoChallengers",
                kGauntletTop + "teams: { zone: {} }\n",
                "x.yaml:1:1: ",
                {"'challengers' is missing"}},
        Mistake{"EmptyChallengers",
                kGauntletTop + "teams: { zone: {} }\nchallengers: {}\n",
                "x.yaml:6:1: challengers: ",
                {"at least one team", "found 0"}},
        Mistake{
            "NoField", kGauntletTop + "challengers: { zone: {} }\n", "x.yaml:1:1: ", {"'teams'"}},
        Mistake{"ChallengerOfTheField",
                kGauntletTop + "teams: { zone: {}, bold: {} }\nchallengers: { zone: {} }\n",
                "x.yaml:6:16: challengers.zone: ",
                {"already has this name"}},
        Mistake{"WrongSettingOfAChallenger",
                kGauntletTop + "teams: { zone: {} }\nchallengers: { bold: { robots: 17 } }\n",
                "x.yaml:6:32: challengers.bold.robots: ",
                {"found '17'"}},
        Mistake{
            "ParameterOfAnotherStrategy",
            kGauntletTop + "teams: { zone: {} }\nchallengers: { bold: { params: { shot: 5 } } }\n",
            "x.yaml:6:34: challengers.bold.params.shot: ",
            {"'shot_mps'"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
