#include "runner/experiments/scenario.hpp"
#include "runner/experiments/reading/effective.hpp"
#include "runner/experiments/reading/scenario_reader.hpp"

#include <gtest/gtest.h>

#include "runner/io/errors.hpp"
#include "runner/settings/fields.hpp"
#include "tests/runner/experiments/reading/mistake.hpp"
#include "tests/runner/support/temporary_folder.hpp"

namespace autoref::runner {
namespace {

const std::string kGame = "schema: 1\nkind: game\n";
const std::string kSweep = "schema: 1\nkind: sweep\npairs: 2\nseed: 1\n";

GameConfiguration game_of(const std::string& text) {
  return std::get<GameConfiguration>(read_scenario_text(text, "x.yaml").content);
}

Sweep sweep_of(const std::string& text) {
  return std::get<Sweep>(read_scenario_text(text, "x.yaml").content);
}

TEST(ReadScenario, GivesDefaultsToWhatIsLeftOut) {
  const GameConfiguration game = game_of(kGame);
  EXPECT_EQ(game.a.robots, 6);
  EXPECT_EQ(game.match.rules, "paper");
  EXPECT_EQ(game.match.half_s, 600);  // the paper's ten minutes
}

TEST(ReadScenario, LetsSingleNumbersChangeAPresetWhereverTheyStand) {
  const GameConfiguration game =
      game_of(kGame + "sim: { ball: { roll_mps2: 0.5, preset: erforce } }\n");
  EXPECT_EQ(game.sim.ball.slide_mps2, 3.92);
  EXPECT_EQ(game.sim.ball.roll_mps2, 0.5);
}

TEST(ReadScenario, WritesTheNumbersOfAPresetIntoTheEffectiveText) {
  const Scenario scenario =
      read_scenario_text(kGame + "sim: { ball: { preset: tigers } }\n", "x.yaml");
  const std::string text = effective_text(scenario);
  EXPECT_NE(text.find("switch_ratio: 0.667"), std::string::npos);
  EXPECT_EQ(text.find("preset"), std::string::npos);
}

TEST(ReadScenario, RefusesAPresetAndItsNumbersAsFactors) {
  EXPECT_THROW(
      sweep_of(kSweep + "factors: { sim.ball.roll_mps2: [0.3], sim.ball.preset: [tigers] }\n"),
      InputError);
}

TEST(ReadScenario, ReadsAGame) {
  const GameConfiguration game =
      game_of(kGame +
              "teams: { a: { strategy: dummy, robots: 3 }, b: { handicap: 0.8, params: { shot_mps: "
              "5 } } }\n"
              "match: { half_s: 60, a_plays: east }\nsim: { substeps: 2 }\nseed: 7\n");
  EXPECT_EQ(game.a.strategy, "dummy");
  EXPECT_EQ(game.a.robots, 3);
  EXPECT_EQ(game.b.acceleration_factor, 0.8);
  EXPECT_EQ(game.b.params.at("shot_mps"), 5);
  EXPECT_EQ(game.match.a_plays, Side::kEast);
  EXPECT_EQ(game.sim.substeps, 2);
  EXPECT_EQ(game.seed, 7U);
}

TEST(ReadScenario, ReadsASweep) {
  const Sweep sweep = sweep_of(kSweep +
                               "base: { match: { half_s: 60 } }\n"
                               "factors: { b.handicap: [1, 0.50], teams.b.robots: [6, 5] }\n");
  EXPECT_EQ(sweep.base.match.half_s, 60);
  EXPECT_EQ(sweep.pairs, 2);
  const std::vector<Factor> expected = {{"b.handicap", {"1.0", "0.5"}}, {"b.robots", {"6", "5"}}};
  EXPECT_EQ(sweep.factors, expected);
}

TEST(ReadScenario, TakesParametersBelowZeroWhereTheirRangeHasThem) {
  const GameConfiguration game =
      game_of(kGame + "teams: { a: { strategy: rowdy, params: { otherwise: -1 } } }\n");
  EXPECT_EQ(game.a.params.at("otherwise"), -1);
}

TEST(ReadScenario, AcceptsFactorsThatOnlyTogetherMakeAGame) {
  const Sweep sweep =
      sweep_of(kSweep + "factors: { field.goal_width_m: [3.8], field.width_m: [9] }\n");
  EXPECT_EQ(sweep.factors.size(), 2U);
}

class WrongScenario : public testing::TestWithParam<Mistake> {};

TEST_P(WrongScenario, IsRefusedWithItsPlaceAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongScenario,
    testing::Values(
        Mistake{"Empty", "", "x.yaml: ", {"empty"}},
        Mistake{"NoYaml", "schema: [1\nkind: game\n", "x.yaml:2:", {"no YAML"}},
        Mistake{"TwoDocuments", kGame + "---\n" + kGame, "x.yaml:4:1: ", {"second"}},
        Mistake{"NoMapping", "- 1\n", "x.yaml:1:1: ", {"expected a mapping", "a list"}},
        Mistake{"NoSchema", "kind: game\n", "x.yaml:1:1: ", {"'schema' is missing"}},
        Mistake{"OtherSchema", "schema: 2\nkind: game\n", "x.yaml:1:9: ", {"schema: expected 1"}},
        Mistake{"UnknownKind", "schema: 1\nkind: duel\n", "x.yaml:2:7: ", {"game, sweep"}},
        Mistake{"UnknownTopKey", kGame + "team: {}\n", "x.yaml:3:1: ", {"'team'", "'teams'"}},
        Mistake{"UnknownKey",
                kGame + "match:\n  halfs: 600\n",
                "x.yaml:4:3: match: ",
                {"unknown key 'halfs'", "did you mean 'half_s'", "halves"}},
        Mistake{"KeyTwice",
                kGame + "match: { half_s: 1, half_s: 2 }\n",
                "x.yaml:3:21: match: ",
                {"'half_s' is given twice", "line 3"}},
        Mistake{"TopKeyTwice", kGame + "seed: 1\nseed: 2\n", "x.yaml:4:1: ", {"twice"}},
        Mistake{"ListAsKey", kGame + "? [1]\n: 2\n", "x.yaml:3:3: ", {"word as key"}},
        Mistake{"Word",
                kGame + "match: { half_s: ten }\n",
                "x.yaml:3:18: match.half_s: ",
                {"expected a number above 0", "found 'ten'", " s,"}},
        Mistake{"QuotedNumber",
                kGame + "match: { half_s: \"60\" }\n",
                "x.yaml:3:18: match.half_s: ",
                {"expected a number", "in quotes"}},
        Mistake{"Nothing",
                kGame + "match: { half_s: }\n",
                "x.yaml:3:10: match.half_s: ",
                {"found nothing"}},
        Mistake{"NoBranch", kGame + "match: 5\n", "x.yaml:3:8: match: ", {"expected a mapping"}},
        Mistake{"EmptyBranch", kGame + "teams:\n", "x.yaml:3:1: ", {"expected a mapping (a, b)"}},
        Mistake{"List", kGame + "seed: [1, 2]\n", "x.yaml:3:7: seed: ", {"found a list"}},
        Mistake{"Fraction",
                kGame + "teams: { a: { robots: 5.5 } }\n",
                "x.yaml:3:23: teams.a.robots: ",
                {"expected a whole number from 1 to 16"}},
        Mistake{"NoRobots",
                kGame + "teams: { a: { robots: 0 } }\n",
                "x.yaml:3:23: teams.a.robots: ",
                {"from 1 to 16, found '0'"}},
        Mistake{"TooManyRobots",
                kGame + "teams: { b: { robots: 17 } }\n",
                "x.yaml:3:23: teams.b.robots: ",
                {"from 1 to 16, found '17'"}},
        Mistake{"NegativeSpeed",
                kGame + "teams: { b: { speed_factor: -0.5 } }\n",
                "x.yaml:3:29: teams.b.speed_factor: ",
                {"above 0", "found '-0.5'"}},
        Mistake{"Infinite", kGame + "match: { half_s: .inf }\n", "x.yaml:3:18: ", {"found '.inf'"}},
        Mistake{"UnknownStrategy",
                kGame + "teams: { b: { strategy: basik } }\n",
                "x.yaml:3:25: teams.b.strategy: ",
                {"basic", "dummy", "found 'basik'"}},
        Mistake{"UnknownRules",
                kGame + "match: { rules: fifa }\n",
                "x.yaml:3:17: match.rules: ",
                {"paper", "found 'fifa'"}},
        Mistake{"UnknownCamera",
                kGame + "sim: { camera: hd }\n",
                "x.yaml:3:16: sim.camera: ",
                {"paper", "found 'hd'"}},
        Mistake{"UnknownParameter",
                kGame + "teams:\n  a: { params: { shot: 1 } }\n",
                "x.yaml:4:18: teams.a.params.shot: ",
                {"did you mean 'shot_mps'"}},
        Mistake{"ParameterOfDummy",
                kGame + "teams: { a: { strategy: dummy, params: { x: 1 } } }\n",
                "x.yaml:3:42: ",
                {"'dummy' has no parameter 'x'", "it has none"}},
        Mistake{"HandicapAndFactor",
                kGame + "teams: { b: { handicap: 0.5, speed_factor: 1 } }\n",
                "x.yaml:3:15: teams.b.handicap: ",
                {"speed_factor", "one of the two"}},
        Mistake{"PlayerThatTheTeamHasNot",
                kGame + "teams:\n  b:\n    players: { 6: { handicap: 0.5 } }\n",
                "x.yaml:5:16: teams.b.players.6: ",
                {"numbered 0 to 5"}},
        Mistake{"PlayerWithoutANumber",
                kGame + "teams: { b: { players: { keeper: { handicap: 0.5 } } } }\n",
                "x.yaml:3:26: teams.b.players: ",
                {"robot's number from 0 to 15", "'keeper'"}},
        Mistake{"PlayersUnknownKey",
                kGame + "teams: { b: { players: { 1: { handicup: 0.5 } } } }\n",
                "x.yaml:3:31: teams.b.players.1: ",
                {"did you mean 'handicap'"}},
        Mistake{"PlayersHandicapAndFactor",
                kGame + "teams: { b: { players: { 1: { handicap: 0.5, speed_factor: 1 } } } }\n",
                "x.yaml:3:31: teams.b.players.1.handicap: ",
                {"one of the two"}},
        Mistake{"PlayersAreNoList",
                kGame + "teams: { b: { players: [1] } }\n",
                "x.yaml:3:24: teams.b.players: ",
                {"expected a mapping"}},
        Mistake{"FactorsBeyondTheirRange",
                kGame + "teams:\n  b: { speed_factor: 2, players: { 1: { speed_factor: 1.5 } } }\n",
                "x.yaml:4:36: teams.b.players.1: ",
                {"with the team's, speed_factor is 3"}},
        Mistake{"TeamsUnknownRobotKey",
                kGame + "teams: { b: { robot: { mass: 3 } } }\n",
                "x.yaml:3:24: teams.b.robot: ",
                {"unknown key 'mass'", "'mass_kg'"}},
        Mistake{
            "TypesName", kGame + "types: { none: {} }\n", "x.yaml:3:10: types: ", {"not 'none'"}},
        Mistake{"TypeAsAScenario",
                "schema: 1\nkind: robot\n",
                "x.yaml:2:7: kind: ",
                {"type of robots"}},
        Mistake{"GoalTooWide",
                kGame + "field: { width_m: 2.5, goal_width_m: 3 }\n",
                "x.yaml:3:24: ",
                {"field.goal_width_m is 3"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Sweeps, WrongScenario,
    testing::Values(
        Mistake{"NoFactors", kSweep, "x.yaml:1:1: ", {"'factors' is missing"}},
        Mistake{"FactorsThatMakeNoGame",
                kSweep + "factors:\n  b.robots: [6]\n  a.params.shot: [1]\n",
                "x.yaml:7:3: teams.a.params.shot: strategy",
                {"did you mean"}},
        Mistake{"NegativeParameter",
                kGame + "teams:\n  a: { params: { shot_mps: -5 } }\n",
                "x.yaml:4:18: teams.a.params.shot_mps: expected a number from 0 to 8 m/s",
                {"found '-5'"}},
        Mistake{"ParameterAboveItsRange",
                kGame + "teams:\n  b: { strategy: rowdy, params: { ram: 1.5 } }\n",
                "x.yaml:4:35: teams.b.params.ram: expected a number from 0 to 1, found '1.5'",
                {}},
        Mistake{"SweptParameterOutOfItsRange",
                kSweep + "factors:\n  a.params.shot_mps: [6.5, 80]\n",
                "x.yaml:6:3: teams.a.params.shot_mps: expected a number from 0 to 8 m/s",
                {"found '80'"}},
        Mistake{"ParameterThatIsNoNumber",
                kGame + "teams:\n  a: { params: { shot_mps: fast } }\n",
                "x.yaml:4:28: teams.a.params.shot_mps: expected a number",
                {"found 'fast'"}},
        Mistake{"LineWidth",
                kGame + "field: { line_width_m: 0.02 }\n",
                "x.yaml:3:10: ",
                {"unknown key 'line_width_m'"}},
        Mistake{"EmptyFactors", kSweep + "factors: {}\n", "x.yaml:5:1: ", {"at least one factor"}},
        Mistake{"NoValues",
                kSweep + "factors: { b.robots: [] }\n",
                "x.yaml:5:22: b.robots: ",
                {"list of values"}},
        Mistake{"OneValue",
                kSweep + "factors: { b.robots: 5 }\n",
                "x.yaml:5:22: b.robots: ",
                {"list of values"}},
        Mistake{"UnknownFactor",
                kSweep + "factors: { b.robot: [5] }\n",
                "x.yaml:5:22: b.robot: ",
                {"did you mean 'b.robots'"}},
        Mistake{"ValueOutOfRange",
                kSweep + "factors: { b.robots: [6, 17] }\n",
                "x.yaml:5:26: b.robots: ",
                {"from 1 to 16, found '17'"}},
        Mistake{"ValueTwice",
                kSweep + "factors: { b.handicap: [1, 1.0] }\n",
                "x.yaml:5:28: b.handicap: ",
                {"1.0 is given twice"}},
        Mistake{"FactorTwice",
                kSweep + "factors: { b.robots: [6], teams.b.robots: [5] }\n",
                "x.yaml:5:27: ",
                {"sets the same number"}},
        Mistake{"HandicapAndItsPart",
                kSweep + "factors: { b.handicap: [1], b.speed_factor: [0.5] }\n",
                "x.yaml:5:29: ",
                {"'b.handicap' sets the same number"}},
        Mistake{"FactorOfAPlayerThatTheTeamHasNot",
                kSweep + "factors: { b.players.6.handicap: [1.0] }\n",
                "x.yaml:5:12: teams.b.players.6: ",
                {"numbered 0 to 5"}},
        Mistake{"PresetOfAPlayerAndItsPart",
                kSweep + "factors: { b.players.1.dribbler.preset: [perfect], "
                         "b.players.1.dribbler.force_n: [1] }\n",
                "x.yaml:5:52: ",
                {"sets the same number"}},
        Mistake{"UnknownTypeAsFactor",
                kSweep + "factors: { b.type: [slow] }\n",
                "x.yaml:5:21: b.type: ",
                {"a file such as robots/slow.yaml"}},
        Mistake{"LegsSide",
                kSweep + "base: { match: { a_plays: east } }\nfactors: { b.robots: [6] }\n",
                "x.yaml:5:18: match.a_plays: ",
                {"leave it out"}},
        Mistake{"KickoffAsFactor",
                kSweep + "factors: { match.first_kickoff: [west, east] }\n",
                "x.yaml:5:12: match.first_kickoff: ",
                {"leave it out"}},
        Mistake{"SeedInBase",
                kSweep + "base: { seed: 1 }\nfactors: { b.robots: [6] }\n",
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
    } catch (const InputError& error) {
      EXPECT_TRUE(
          std::string(error.what()).starts_with(path.string() + ": the file cannot be read"));
    }
  }
}

TEST(EffectiveConfiguration, OfAGameReadsBackEqual) {
  GameConfiguration game;
  game.a.robots = 3;
  game.b.speed_factor = 1.0 / 3.0;
  game.a.params["shot_mps"] = 0.1;
  game.match.a_plays = Side::kEast;
  game.field.defence_area.shape = DefenceArea::Shape::kBox;
  game.seed = 18446744073709551615ULL;
  const Scenario scenario{"A \"quoted\"\nsentence: #1", game};
  const Scenario back = read_scenario_text(effective_text(scenario), "effective.yaml");
  EXPECT_EQ(back.about, scenario.about);
  EXPECT_EQ(configuration_hash(std::get<GameConfiguration>(back.content)),
            configuration_hash(game));
}

TEST(EffectiveConfiguration, OfASweepReadsBackEqual) {
  Sweep sweep;
  sweep.base.match.half_s = 60;
  sweep.factors = {{"b.handicap", {"1.0", "0.5"}}, {"a.strategy", {"basic", "dummy"}}};
  sweep.pairs = 30;
  sweep.seed = 7;
  const Sweep back = sweep_of(effective_text({"", sweep}));
  EXPECT_EQ(configuration_hash(back.base), configuration_hash(sweep.base));
  EXPECT_EQ(back.factors, sweep.factors);
  EXPECT_EQ(back.pairs, 30);
  EXPECT_EQ(back.seed, 7U);
}

}  // namespace
}  // namespace autoref::runner
