#include "experiments/kinds/roundrobin/roundrobin.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/reading/named_teams_reader.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/fields.hpp"
#include "tests/experiments/reading/mistake.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::experiments {
namespace {

const std::string kTop = "schema: 1\nkind: roundrobin\npairs: 2\nseed: 7\n";
const std::string kTeams = "teams: { zone: {}, bold: { strategy: dummy } }\n";

RoundRobin robin_read_from(const std::string& text, const std::string& file = "x.yaml") {
  return *read_scenario_text(text, file).as<RoundRobin>();
}

TEST(ReadRoundRobin, ReadsTeamsBasePairsAndSeed) {
  const RoundRobin robin = robin_read_from(
      kTop +
      "base: { match: { half_s: 60 } }\n"
      "teams: { zone: { handicap: 0.8, params: { shot_mps: 5 } }, bold: { robots: 3 } }\n");
  ASSERT_EQ(robin.teams.size(), 2U);
  EXPECT_EQ(robin.teams.at("zone").speed_factor, 0.8);
  EXPECT_EQ(robin.teams.at("zone").params.at("shot_mps"), 5);
  EXPECT_EQ(robin.teams.at("bold").robots, 3);
  EXPECT_EQ(robin.base.match.half_s, 60);
  EXPECT_EQ(robin.pairs, 2);
  EXPECT_EQ(robin.seed, 7U);
}

// 2026, Division A: eleven robots per team.
TEST(ReadRoundRobin, TakesTheNumberOfRobotsFromTheBasesRulesInAnyOrder) {
  const RoundRobin robin = robin_read_from(kTop + kTeams + "base: { match: { rules: 2026-a } }\n");
  EXPECT_EQ(robin.teams.at("zone").robots, 11);
}

TEST(ReadRoundRobin, TakesRobotTypesFromFilesAndFromTheBase) {
  const TemporaryFolder folder;
  write_content(folder / "slow.yaml", "schema: 1\nkind: robot\nrobot: { speed_mps: 1.5 }\n");
  const RoundRobin robin =
      robin_read_from(kTop +
                          "base: { types: { fast: { robot: { speed_mps: 4 } } } }\n"
                          "teams: { zone: { type: fast }, bold: { type: slow.yaml, "
                          "players: { 2: { type: fast } } } }\n",
                      folder / "x.yaml");
  EXPECT_EQ(robin.base.types.at("slow").at("robot.speed_mps"), game::SettingValue(1.5));
  EXPECT_EQ(robin.teams.at("bold").type, "slow");
  EXPECT_EQ(robin.teams.at("bold").players.at(2).type, "fast");
}

TEST(EffectiveConfiguration, OfARoundRobinReadsBackEqual) {
  RoundRobin robin = robin_read_from(kTop + kTeams);
  robin.base.match.half_s = 60;
  robin.base.types["slow"] = {{"robot.speed_mps", 1.5}};
  robin.teams["zone"].params["shot_mps"] = 0.1;
  robin.teams["zone"].players[3].type = "slow";
  const std::vector<ScheduledGame> there = robin.games();
  const std::vector<ScheduledGame> back = robin_read_from(effective_text({"", robin})).games();
  ASSERT_EQ(back.size(), there.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].id, there[i].id);
    EXPECT_EQ(game::configuration_hash(back[i].settings.combined()),
              game::configuration_hash(there[i].settings.combined()));
  }
}

class WrongRoundRobin : public testing::TestWithParam<Mistake> {};

TEST_P(WrongRoundRobin, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongRoundRobin,
    testing::Values(
        Mistake{"NoTeams", kTop, "x.yaml:1:1: ", {"'teams' is missing"}},
        Mistake{"NoPairs",
                "schema: 1\nkind: roundrobin\nseed: 1\n" + kTeams,
                "x.yaml:1:1: ",
                {"'pairs' is missing"}},
        Mistake{"OneTeam",
                kTop + "teams: { zone: {} }\n",
                "x.yaml:5:1: teams: ",
                {"at least 2 teams", "found 1"}},
        Mistake{"EmptyTeams", kTop + "teams: {}\n", "x.yaml:5:1: teams: ", {"found 0"}},
        Mistake{
            "ListOfTeams", kTop + "teams: [zone, bold]\n", "x.yaml:5:8: teams: ", {"a mapping"}},
        Mistake{"TeamTwice",
                kTop + "teams: { zone: {}, zone: {} }\n",
                "x.yaml:5:20: teams: ",
                {"'zone' is given twice"}},
        Mistake{"Tilde",
                kTop + "teams: { zone: {}, a~b: {} }\n",
                "x.yaml:5:20: teams: ",
                {"letters, digits, - and _", "'a~b'"}},
        Mistake{"PairInAName",
                kTop + "teams: { zone: {}, zone-p1: {} }\n",
                "x.yaml:5:20: teams: ",
                {"without '-p'", "write _p", "'zone-p1'"}},
        Mistake{"EmptyName",
                kTop + "teams: { zone: {}, \"\": {} }\n",
                "x.yaml:5:20: teams: ",
                {"letters"}},
        Mistake{"UnknownKey", kTop + kTeams + "pair: 5\n", "x.yaml:6:1: ", {"'pair'", "'pairs'"}},
        Mistake{"Factors", kTop + kTeams + "factors: {}\n", "x.yaml:6:1: ", {"unknown key"}},
        Mistake{"UnknownKeyOfATeam",
                kTop + "teams: { zone: { robot_s: 5 }, bold: {} }\n",
                "x.yaml:5:18: teams.zone: ",
                {"'robots'"}},
        Mistake{"UnknownStrategy",
                kTop + "teams: { zone: { strategy: basik }, bold: {} }\n",
                "x.yaml:5:28: teams.zone.strategy: ",
                {"basic", "found 'basik'"}},
        Mistake{"UnknownParameter",
                kTop + "teams: { bold: {}, zone: { params: { shot: 5 } } }\n",
                "x.yaml:5:38: teams.zone.params.shot: ",
                {"'shot_mps'"}},
        Mistake{"ParameterOutOfItsRange",
                kTop + "teams: { bold: {}, zone: { params: { shot_mps: 9 } } }\n",
                "x.yaml:5:38: teams.zone.params.shot_mps: ",
                {"from 0 to 8 m/s", "found '9'"}},
        Mistake{"PlayerThatTheTeamHasNot",
                kTop + "teams: { bold: {}, zone: { players: { 6: { handicap: 0.5 } } } }\n",
                "x.yaml:5:39: teams.zone.players.6: ",
                {"numbered 0 to 5"}},
        Mistake{"TeamIsAWord",
                kTop + "teams: { bold: {}, zone: basic }\n",
                "x.yaml:5:26: teams.zone: ",
                {"expected a mapping (strategy"}},
        Mistake{"TeamsInTheBase",
                kTop + kTeams + "base: { teams: { a: { strategy: basic } } }\n",
                "x.yaml:6:9: base.teams: ",
                {"outside the base"}},
        Mistake{"SeedInTheBase", kTop + kTeams + "base: { seed: 1 }\n", "x.yaml:6:9: base: ", {}},
        Mistake{"LegsSide",
                kTop + kTeams + "base: { match: { a_plays: east } }\n",
                "x.yaml:6:18: match.a_plays: ",
                {"leave it out"}},
        Mistake{"TooManyGames",
                "schema: 1\nkind: roundrobin\npairs: 9999\nseed: 1\n"
                "teams: { a: {}, b: {}, c: {}, d: {} }\n",
                "x.yaml:3:1: pairs: ",
                {"119988 games"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
