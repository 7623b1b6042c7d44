// The keys of versions in scenario files, and that they change no game.
#include "experiments/kinds/version_keys.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/gauntlet/gauntlet.hpp"
#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "game/settings/setting_value.hpp"
#include "io/errors.hpp"
#include "tests/experiments/reading/mistake.hpp"

namespace autoref::experiments {
namespace {

const std::string kRobinTop = "schema: 1\nkind: roundrobin\npairs: 2\nseed: 7\n";
const std::string kFieldTop = "schema: 1\nkind: gauntlet\npairs: 2\nseed: 7\nteams: { zone: {} }\n";
const std::string kVersionedRobin =
    kRobinTop +
    "teams:\n  v1: { version: 2026-09-01, version_of: mine, robots: 5 }\n"
    "  v2: { strategy: zone, version: 2026-10-01, version_of: mine }\n  basic: {}\n"
    "anchors: [basic]\nearlier: ../old\n";

TEST(ReadVersions, ReadsDatesLinesAnchorsAndTheEarlierFolder) {
  const Scenario scenario = read_scenario_text(kVersionedRobin, "/lab/scenarios/x.yaml");
  const TeamVersions& versions = scenario.get<RoundRobin>().versions;
  ASSERT_EQ(versions.of_teams.size(), 2U);
  EXPECT_EQ(versions.of_teams.at("v1").date, "2026-09-01");
  EXPECT_EQ(versions.of_teams.at("v2").line, "mine");
  EXPECT_EQ(versions.anchors, std::vector<std::string>{"basic"});
  EXPECT_EQ(versions.earlier, "/lab/old");
  EXPECT_EQ(scenario.get<RoundRobin>().teams.at("v1").robots, 5);
}

TEST(ReadVersions, ReadsThoseOfChallengers) {
  const Scenario scenario =
      read_scenario_text(kFieldTop + "challengers: { v1: { version: 2026-09-01 } }\n", "x.yaml");
  EXPECT_EQ(scenario.get<Gauntlet>().versions.of_teams.at("v1").date, "2026-09-01");
}

TEST(EffectiveConfiguration, OfVersionsReadsBackEqual) {
  Scenario scenario = read_scenario_text(kVersionedRobin, "/lab/scenarios/x.yaml");
  scenario.as<RoundRobin>()->versions.taken_over =
      TakenOver{"1.0", {{"v1", {"0.9", 0.1, 8, {{1, 1.0 / 3}, {3, -2}}}}}};
  const std::string text = effective_text(scenario);
  const Scenario again = read_scenario_text(text, "/elsewhere/effective.yaml");
  EXPECT_EQ(effective_text(again), text);
  const EarlierTeam& team = again.get<RoundRobin>().versions.taken_over.value().teams.at("v1");
  EXPECT_EQ(team.by_pair, (DifferenceByPair{{1, 1.0 / 3}, {3, -2}}));
  EXPECT_EQ(team.build, "0.9");
  EXPECT_EQ(team.offset, 0.1);
  EXPECT_EQ(team.games, 8);
}

TEST(Versions, ChangeNoGame) {
  const auto games_in = [](const std::string& text) {
    return read_scenario_text(kRobinTop + text, "x.yaml").experiment().games();
  };
  const auto with = games_in(
      "teams: { v1: { version: 2026-09-01, version_of: mine }, basic: {} }\nanchors: [basic]\n");
  const auto without = games_in("teams: { v1: {}, basic: {} }\n");
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i].id, without[i].id);
    EXPECT_EQ(with[i].settings.leg().seed, without[i].settings.leg().seed);
    EXPECT_EQ(game::configuration_hash(with[i].settings.combined()),
              game::configuration_hash(without[i].settings.combined()));
  }
}

TEST(Versions, ChangeNoEffectiveConfigurationOfTeamsWithoutThem) {
  const std::string text =
      effective_text(read_scenario_text(kRobinTop + "teams: { v1: {}, basic: {} }\n", "x.yaml"));
  EXPECT_EQ(text.find("version"), std::string::npos);
}

TEST(TooManyGames, AreThoseOfThePlayedTeams) {
  const TakenOver taken_over{"1.0", {{"v1", {}}, {"v2", {}}}};
  RoundRobin robin;
  robin.teams = {{"v1", {}}, {"v2", {}}, {"v3", {}}, {"v4", {}}};
  robin.pairs = 9999;  // 119988 games of four teams
  EXPECT_THROW(robin.games(), game::SettingError);
  robin.versions.taken_over = taken_over;
  EXPECT_EQ(robin.games().size(), 2U * 9999);
  Gauntlet gauntlet;
  gauntlet.teams = {{"zone", {}}, {"basic", {}}};
  gauntlet.challengers = {{"v1", {}}, {"v2", {}}, {"v3", {}}};
  gauntlet.pairs = 9999;  // 119988 games of three challengers
  EXPECT_THROW(gauntlet.games(), game::SettingError);
  gauntlet.versions.taken_over = taken_over;
  EXPECT_EQ(gauntlet.games().size(), 4U * 9999);
}

TEST(Set, LeavesDatesToTheFile) {
  for (const char* key : {"version=2026-03-01", "version_of=mine"}) {
    try {
      read_scenario_text(kFieldTop + "challengers: { v1: {} }\n", "x.yaml",
                         game::assignments_in({std::string("challengers.v1.") + key}));
      FAIL() << "accepted";
    } catch (const io::InputError& error) {
      EXPECT_EQ(std::string(error.what()),
                std::string("--set challengers.v1.") + key +
                    ": version and version_of can only be set in the file");
    }
  }
}

// An experiment that took over a team with `games` games and ratings of some pairs.
std::string taken_over_text(const std::string& games, int pairs) {
  std::string ratings;
  for (int pair = 1; pair <= pairs; ++pair) ratings += pair == 1 ? "1" : ", 1";
  return kFieldTop + "challengers: { v1: {} }\ntaken_over: { build: x, teams: { v1: { build: y, " +
         "offset: 0, games: " + games + ", by_pair: [" + ratings + "] } } }\n";
}

class WrongVersion : public testing::TestWithParam<Mistake> {};

TEST_P(WrongVersion, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongVersion,
    testing::Values(
        Mistake{"NoDate",
                kRobinTop + "teams: { v1: { version: 2026-02-29 }, zone: {} }\n",
                "x.yaml:5:16: ",
                {"teams.v1.version", "such as 2026-09-01", "'2026-02-29'"}},
        Mistake{"LineWithoutDate",
                kRobinTop + "teams: { v1: { version_of: mine }, zone: {} }\n",
                "x.yaml:5:16: ",
                {"teams.v1.version_of", "add version: 2026-09-01"}},
        Mistake{"OfTheField",
                "schema: 1\nkind: gauntlet\npairs: 2\nseed: 7\nteams: { zone: { version: "
                "2026-09-01 } }\nchallengers: { v1: {} }\n",
                "x.yaml:5:18: teams.zone.version: ",
                {"challengers of a gauntlet"}},
        Mistake{"OfAnotherKind",
                "schema: 1\nkind: swiss\npairs: 2\nseed: 7\nrounds: 1\nteams: { zone: { version: "
                "2026-09-01 }, bold: {} }\n",
                "x.yaml:6:18: teams.zone.version: ",
                {"roundrobin"}},
        Mistake{"AnchorOfTheField",
                kFieldTop + "challengers: { v1: {} }\nanchors: [zone]\n",
                "x.yaml:7:10: ",
                {"'zone' is not one of the challengers", "v1"}},
        Mistake{"EmptyFolder",
                kFieldTop + "challengers: { v1: {} }\nearlier: ''\n",
                "x.yaml:7:10: earlier: ",
                {"results folder"}},
        Mistake{"DamagedRating",
                kFieldTop + "challengers: { v1: {} }\ntaken_over: { build: x, teams: { v1: { "
                            "build: y, offset: 0, games: 2, by_pair: [1, many] } } }\n",
                "x.yaml:7:",
                {"taken_over", "'many'"}},
        Mistake{"DamagedGames",
                taken_over_text("1e300", 1),
                "x.yaml:7:",
                {"taken_over", "number of games", "'1e300'"}},
        Mistake{"TooManyPairs",
                taken_over_text("2", 10000),
                "x.yaml:7:",
                {"taken_over", "at most 9999 pairs"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
