// Error messages for invalid scenarios name file, line, key and what was expected.
#include <gtest/gtest.h>

#include <filesystem>

#include "experiments/kinds/scenario.hpp"
#include "io/errors.hpp"
#include "tests/experiments/reading/mistake.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::experiments {
namespace {

const std::string kGameTop = "schema: 1\nkind: game\n";
const std::string kSweepTop = "schema: 1\nkind: sweep\npairs: 2\nseed: 1\n";

class WrongScenario : public testing::TestWithParam<Mistake> {};

TEST_P(WrongScenario, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongScenario,
    testing::Values(
        Mistake{"Empty", "", "x.yaml: ", {"empty"}},
        Mistake{"NoYaml", "schema: [1\nkind: game\n", "x.yaml:2:", {"invalid YAML"}},
        Mistake{"TwoDocuments", kGameTop + "---\n" + kGameTop, "x.yaml:4:1: ", {"second"}},
        Mistake{"NoMapping", "- 1\n", "x.yaml:1:1: ", {"expected a mapping", "a list"}},
        Mistake{"NoSchema", "kind: game\n", "x.yaml:1:1: ", {"'schema' is missing"}},
        Mistake{"OtherSchema", "schema: 2\nkind: game\n", "x.yaml:1:9: ", {"schema: expected 1"}},
        Mistake{"UnknownKind", "schema: 1\nkind: duel\n", "x.yaml:2:7: ", {"game, compare, sweep"}},
        Mistake{"UnknownTopKey", kGameTop + "team: {}\n", "x.yaml:3:1: ", {"'team'", "'teams'"}},
        Mistake{"UnknownKey",
                kGameTop + "match:\n  halfs: 600\n",
                "x.yaml:4:3: match: ",
                {"unknown key 'halfs'", "did you mean 'half_s'", "halves"}},
        Mistake{"KeyTwice",
                kGameTop + "match: { half_s: 1, half_s: 2 }\n",
                "x.yaml:3:21: match: ",
                {"'half_s' is given twice", "line 3"}},
        Mistake{"TopKeyTwice", kGameTop + "seed: 1\nseed: 2\n", "x.yaml:4:1: ", {"twice"}},
        Mistake{"ListAsKey", kGameTop + "? [1]\n: 2\n", "x.yaml:3:3: ", {"word as key"}},
        Mistake{"Word",
                kGameTop + "match: { half_s: ten }\n",
                "x.yaml:3:18: match.half_s: ",
                {"expected a number above 0", "found 'ten'", " s,"}},
        Mistake{"QuotedNumber",
                kGameTop + "match: { half_s: \"60\" }\n",
                "x.yaml:3:18: match.half_s: ",
                {"expected a number", "in quotes"}},
        Mistake{"Nothing",
                kGameTop + "match: { half_s: }\n",
                "x.yaml:3:10: match.half_s: ",
                {"found nothing"}},
        Mistake{"NoBranch", kGameTop + "match: 5\n", "x.yaml:3:8: match: ", {"expected a mapping"}},
        Mistake{
            "EmptyBranch", kGameTop + "teams:\n", "x.yaml:3:1: ", {"expected a mapping (a, b)"}},
        Mistake{"List", kGameTop + "seed: [1, 2]\n", "x.yaml:3:7: seed: ", {"found a list"}},
        Mistake{"Fraction",
                kGameTop + "teams: { a: { robots: 5.5 } }\n",
                "x.yaml:3:23: teams.a.robots: ",
                {"expected a whole number from 1 to 16"}},
        Mistake{"NoRobots",
                kGameTop + "teams: { a: { robots: 0 } }\n",
                "x.yaml:3:23: teams.a.robots: ",
                {"from 1 to 16, found '0'"}},
        Mistake{"TooManyRobots",
                kGameTop + "teams: { b: { robots: 17 } }\n",
                "x.yaml:3:23: teams.b.robots: ",
                {"from 1 to 16, found '17'"}},
        Mistake{"NegativeSpeed",
                kGameTop + "teams: { b: { speed_factor: -0.5 } }\n",
                "x.yaml:3:29: teams.b.speed_factor: ",
                {"above 0", "found '-0.5'"}},
        Mistake{
            "Infinite", kGameTop + "match: { half_s: .inf }\n", "x.yaml:3:18: ", {"found '.inf'"}},
        Mistake{"UnknownStrategy",
                kGameTop + "teams: { b: { strategy: basik } }\n",
                "x.yaml:3:25: teams.b.strategy: ",
                {"basic", "dummy", "found 'basik'"}},
        Mistake{"UnknownRules",
                kGameTop + "match: { rules: fifa }\n",
                "x.yaml:3:17: match.rules: ",
                {"paper", "found 'fifa'"}},
        Mistake{"UnknownCamera",
                kGameTop + "sim: { camera: hd }\n",
                "x.yaml:3:16: sim.camera: ",
                {"paper", "found 'hd'"}},
        Mistake{"UnknownParameter",
                kGameTop + "teams:\n  a: { params: { shot: 1 } }\n",
                "x.yaml:4:18: teams.a.params.shot: ",
                {"did you mean 'shot_mps'"}},
        Mistake{"ParameterOfDummy",
                kGameTop + "teams: { a: { strategy: dummy, params: { x: 1 } } }\n",
                "x.yaml:3:42: ",
                {"'dummy' has no parameter 'x'", "it has none"}},
        Mistake{"HandicapAndFactor",
                kGameTop + "teams: { b: { handicap: 0.5, speed_factor: 1 } }\n",
                "x.yaml:3:15: teams.b.handicap: ",
                {"speed_factor", "one of the two"}},
        Mistake{"PlayerThatTheTeamHasNot",
                kGameTop + "teams:\n  b:\n    players: { 6: { handicap: 0.5 } }\n",
                "x.yaml:5:16: teams.b.players.6: ",
                {"numbered 0 to 5"}},
        Mistake{"PlayerWithoutANumber",
                kGameTop + "teams: { b: { players: { keeper: { handicap: 0.5 } } } }\n",
                "x.yaml:3:26: teams.b.players: ",
                {"robot's number from 0 to 15", "'keeper'"}},
        Mistake{"PlayersUnknownKey",
                kGameTop + "teams: { b: { players: { 1: { handicup: 0.5 } } } }\n",
                "x.yaml:3:31: teams.b.players.1: ",
                {"did you mean 'handicap'"}},
        Mistake{"PlayersHandicapAndFactor",
                kGameTop + "teams: { b: { players: { 1: { handicap: 0.5, speed_factor: 1 } } } }\n",
                "x.yaml:3:31: teams.b.players.1.handicap: ",
                {"one of the two"}},
        Mistake{"PlayersAreNoList",
                kGameTop + "teams: { b: { players: [1] } }\n",
                "x.yaml:3:24: teams.b.players: ",
                {"expected a mapping"}},
        Mistake{
            "FactorsBeyondTheirRange",
            kGameTop + "teams:\n  b: { speed_factor: 2, players: { 1: { speed_factor: 1.5 } } }\n",
            "x.yaml:4:36: teams.b.players.1: ",
            {"combined with the team's settings, speed_factor is 3"}},
        Mistake{"TeamsUnknownRobotKey",
                kGameTop + "teams: { b: { robot: { mass: 3 } } }\n",
                "x.yaml:3:24: teams.b.robot: ",
                {"unknown key 'mass'", "'mass_kg'"}},
        Mistake{"TypesName",
                kGameTop + "types: { none: {} }\n",
                "x.yaml:3:10: types: ",
                {"not be 'none'"}},
        Mistake{
            "TypeAsAScenario", "schema: 1\nkind: robot\n", "x.yaml:2:7: kind: ", {"robot type"}},
        Mistake{"GoalTooWide",
                kGameTop + "field: { width_m: 2.5, goal_width_m: 3 }\n",
                "x.yaml:3:24: ",
                {"field.goal_width_m is 3"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Sweeps, WrongScenario,
    testing::Values(
        Mistake{"NoFactors", kSweepTop, "x.yaml:1:1: ", {"'factors' is missing"}},
        Mistake{"FactorsThatMakeNoGame",
                kSweepTop + "factors:\n  b.robots: [6]\n  a.params.shot: [1]\n",
                "x.yaml:7:3: teams.a.params.shot: strategy",
                {"did you mean"}},
        Mistake{"NegativeParameter",
                kGameTop + "teams:\n  a: { params: { shot_mps: -5 } }\n",
                "x.yaml:4:18: teams.a.params.shot_mps: expected a number from 0 to 8 m/s",
                {"found '-5'"}},
        Mistake{"ParameterAboveItsRange",
                kGameTop + "teams:\n  b: { strategy: rowdy, params: { ram: 1.5 } }\n",
                "x.yaml:4:35: teams.b.params.ram: expected a number from 0 to 1, found '1.5'",
                {}},
        Mistake{"FlagBetweenZeroAndOne",
                kGameTop + "teams:\n  a: { strategy: cobalt, params: { around_boxes: 0.5 } }\n",
                "x.yaml:4:36: teams.a.params.around_boxes: expected 0 or 1, found '0.5'",
                {}},
        Mistake{"SweptParameterOutOfItsRange",
                kSweepTop + "factors:\n  a.params.shot_mps: [6.5, 80]\n",
                "x.yaml:6:3: teams.a.params.shot_mps: expected a number from 0 to 8 m/s",
                {"found '80'"}},
        Mistake{"ParameterThatIsNoNumber",
                kGameTop + "teams:\n  a: { params: { shot_mps: fast } }\n",
                "x.yaml:4:28: teams.a.params.shot_mps: expected a number",
                {"found 'fast'"}},
        Mistake{"GoalWallHeight",
                kGameTop + "field: { goal_wall_height_m: 0.2 }\n",
                "x.yaml:3:10: ",
                {"unknown key 'goal_wall_height_m'"}},
        Mistake{
            "EmptyFactors", kSweepTop + "factors: {}\n", "x.yaml:5:1: ", {"at least one factor"}},
        Mistake{"NoValues",
                kSweepTop + "factors: { b.robots: [] }\n",
                "x.yaml:5:22: b.robots: ",
                {"list of values"}},
        Mistake{"OneValue",
                kSweepTop + "factors: { b.robots: 5 }\n",
                "x.yaml:5:22: b.robots: ",
                {"list of values"}},
        Mistake{"UnknownFactor",
                kSweepTop + "factors: { b.robot: [5] }\n",
                "x.yaml:5:22: b.robot: ",
                {"did you mean 'b.robots'"}},
        Mistake{"ValueOutOfRange",
                kSweepTop + "factors: { b.robots: [6, 17] }\n",
                "x.yaml:5:26: b.robots: ",
                {"from 1 to 16, found '17'"}},
        Mistake{"ValueTwice",
                kSweepTop + "factors: { b.handicap: [1, 1.0] }\n",
                "x.yaml:5:28: b.handicap: ",
                {"1.0 is given twice"}},
        Mistake{"FactorTwice",
                kSweepTop + "factors: { b.robots: [6], teams.b.robots: [5] }\n",
                "x.yaml:5:27: ",
                {"sets the same value"}},
        Mistake{"HandicapAndItsPart",
                kSweepTop + "factors: { b.handicap: [1], b.speed_factor: [0.5] }\n",
                "x.yaml:5:29: ",
                {"'b.handicap' sets the same value"}},
        Mistake{"FactorOfAPlayerThatTheTeamHasNot",
                kSweepTop + "factors: { b.players.6.handicap: [1.0] }\n",
                "x.yaml:5:12: teams.b.players.6: ",
                {"numbered 0 to 5"}},
        Mistake{"UnknownTypeAsFactor",
                kSweepTop + "factors: { b.type: [slow] }\n",
                "x.yaml:5:21: b.type: ",
                {"a file such as robots/slow.yaml"}},
        Mistake{"LegsSide",
                kSweepTop + "base: { match: { a_plays: east } }\nfactors: { b.robots: [6] }\n",
                "x.yaml:5:18: match.a_plays: ",
                {"leave it out"}},
        Mistake{"KickoffAsFactor",
                kSweepTop + "factors: { match.first_kickoff: [west, east] }\n",
                "x.yaml:5:12: match.first_kickoff: ",
                {"leave it out"}},
        Mistake{"SeedInBase",
                kSweepTop + "base: { seed: 1 }\nfactors: { b.robots: [6] }\n",
                "x.yaml:5:9: base: ",
                {"unknown key 'seed'"}},
        Mistake{"NoPairs",
                "schema: 1\nkind: sweep\nseed: 1\nfactors: { b.robots: [6] }\n",
                "x.yaml:1:1: ",
                {"'pairs' is missing"}},
        Mistake{"TooManyGames",
                "schema: 1\nkind: sweep\npairs: 9999\nseed: 1\n"
                "factors: { a.robots: [1, 2, 3], b.robots: [1, 2, 3] }\n",
                "x.yaml:3:1: pairs: ",
                {"179982 games", "at most 100000"}},
        Mistake{"ZeroPairs",
                "schema: 1\nkind: sweep\npairs: 0\nseed: 1\nfactors: { b.robots: [6] }\n",
                "x.yaml:3:8: pairs: ",
                {"from 1 to 9999"}}),
    [](const auto& test) { return test.param.name; });

TEST(ReadScenario, NamesAFileThatCannotBeRead) {
  const TemporaryFolder folder;
  for (const std::filesystem::path& path : std::initializer_list<std::filesystem::path>{
           folder / "none.yaml", folder.path(), "/dev/zero"}) {
    try {
      read_scenario(path);
      FAIL();
    } catch (const io::InputError& error) {
      EXPECT_TRUE(
          std::string(error.what()).starts_with(path.string() + ": the file cannot be read"));
    }
  }
}

}  // namespace
}  // namespace autoref::experiments
