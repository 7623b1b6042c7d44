// Common mistakes in scenario files, one at a time: each is refused with file, line, key and a
// remedy.
#include <gtest/gtest.h>

#include <stdexcept>

#include "experiments/kinds/scenario_reader.hpp"
#include "tests/experiments/reading/mistake.hpp"

namespace autoref::experiments {
namespace {

const std::string kCorrectSweep =
    "schema: 1\n"
    "kind: sweep\n"
    "pairs: 2\n"
    "seed: 1\n"
    "base: { match: { half_s: 60 } }\n"
    "factors: { b.robots: [6, 5] }\n";

const std::string kCorrectRobin =
    "schema: 1\n"
    "kind: roundrobin\n"
    "pairs: 2\n"
    "seed: 1\n"
    "teams: { bold: { strategy: basic }, calm: { strategy: zone } }\n";

const std::string kCorrectGame =
    "schema: 1\n"
    "kind: game\n"
    "teams: { a: { strategy: basic }, b: { strategy: zone } }\n"
    "match: { rules: paper, half_s: 60 }\n";

// `text` with the first occurrence of `what` replaced.
std::string changed(std::string text, const std::string& what, const std::string& by) {
  const std::size_t index = text.find(what);
  if (index == std::string::npos) throw std::logic_error("there is no " + what);
  return text.replace(index, what.size(), by);
}

TEST(Mistakes, AreTheOnlyReasonForRefusal) {
  for (const std::string& text : {kCorrectSweep, kCorrectRobin, kCorrectGame}) {
    EXPECT_NO_THROW(read_scenario_text(text, "x.yaml"));
  }
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreRefusedWithLocationKeyAndRemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    TeamsOnTheNetwork, Mistakes,
    testing::Values(
        Mistake{"Sweep",
                changed(kCorrectSweep, "match: {", "teams: { a: { strategy: network } }, match: {"),
                "x.yaml:5:",
                {"teams.a.strategy", "can only play in autoref live"}},
        Mistake{"GameController",
                changed(kCorrectSweep, "match: {", "match: { control: game-controller,"),
                "x.yaml:5:",
                {"match.control", "can only command games of autoref play"}},
        Mistake{"RoundRobin",
                changed(kCorrectRobin, "strategy: zone", "strategy: network"),
                "x.yaml:5:",
                {"strategy", "can only play in autoref live"}}),
    [](const auto& one) { return one.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Sweeps, Mistakes,
    testing::Values(Mistake{"UnknownKey",
                            kCorrectSweep + "pair: 5\n",
                            "x.yaml:7:1: unknown key 'pair'",
                            {"did you mean 'pairs'?", "schema, kind"}},
                    Mistake{"KeyOfOtherKinds",
                            kCorrectSweep + "teams: {}\n",
                            "x.yaml:7:1: unknown key 'teams'. Known here: schema, kind",
                            {}},
                    Mistake{"KeyTwice",
                            kCorrectSweep + "seed: 2\n",
                            "x.yaml:7:1: the key 'seed' is given twice, first in line 4",
                            {"leave one out"}},
                    Mistake{"WordForANumber",
                            changed(kCorrectSweep, "pairs: 2", "pairs: two"),
                            "x.yaml:3:8: pairs: expected a whole number from 1 to 9999",
                            {"found 'two'"}},
                    Mistake{"NoPairs",
                            changed(kCorrectSweep, "pairs: 2", "pairs: 0"),
                            "x.yaml:3:8: pairs: ",
                            {"from 1 to 9999", "found '0'"}},
                    Mistake{"NegativeSeed",
                            changed(kCorrectSweep, "seed: 1", "seed: -1"),
                            "x.yaml:4:7: seed: ",
                            {"from 0 to 2^64 - 1", "found '-1'"}},
                    Mistake{"UnknownKind",
                            changed(kCorrectSweep, "sweep", "sweeps"),
                            "x.yaml:2:7: kind: expected one of ",
                            {"found 'sweeps'; did you mean 'sweep'?"}},
                    Mistake{"MissingKind",
                            changed(kCorrectSweep, "kind: sweep\n", ""),
                            "x.yaml:1:1: the key 'kind' is missing",
                            {"add it, such as kind: sweep"}},
                    Mistake{"MissingSchema",
                            changed(kCorrectSweep, "schema: 1\n", ""),
                            "x.yaml:1:1: the key 'schema' is missing",
                            {"schema: 1"}},
                    Mistake{"OtherSchema",
                            changed(kCorrectSweep, "schema: 1", "schema: 2"),
                            "x.yaml:1:9: schema: expected 1, the only schema so far",
                            {"found '2'"}},
                    Mistake{"MissingFactors",
                            changed(kCorrectSweep, "factors: { b.robots: [6, 5] }\n", ""),
                            "x.yaml:1:1: the key 'factors' is missing",
                            {"factors: { b.handicap: [1.0, 0.9] }"}},
                    Mistake{"FactorWithoutValues",
                            changed(kCorrectSweep, "[6, 5]", "[]"),
                            "x.yaml:6:22: b.robots: expected a non-empty list of values",
                            {"such as [1.0, 0.9]"}},
                    Mistake{"FactorWithOneValueNoList",
                            changed(kCorrectSweep, "[6, 5]", "5"),
                            "x.yaml:6:22: b.robots: expected a non-empty list",
                            {"such as [1.0, 0.9]"}},
                    Mistake{"UnknownFactor",
                            changed(kCorrectSweep, "b.robots", "b.robot"),
                            "x.yaml:6:22: b.robot: unknown key",
                            {"did you mean 'b.robots'?"}},
                    Mistake{"FactorLikeNothing",
                            changed(kCorrectSweep, "b.robots", "base.b.robots"),
                            "x.yaml:6:28: base.b.robots: unknown key",
                            {"such as b.handicap"}},
                    Mistake{"RobotsOutOfRange",
                            changed(kCorrectSweep, "[6, 5]", "[6, 17]"),
                            "x.yaml:6:26: b.robots: expected a whole number from 1 to 16",
                            {"found '17'"}},
                    Mistake{"HandicapOutOfRange",
                            changed(kCorrectSweep, "b.robots: [6, 5]", "b.handicap: [2.5]"),
                            "x.yaml:6:25: b.handicap: expected a number above 0 and at most 2",
                            {"found '2.5'"}},
                    Mistake{"ValueTwice",
                            changed(kCorrectSweep, "[6, 5]", "[6, 6]"),
                            "x.yaml:6:26: b.robots: the value 6 is given twice",
                            {"leave one out"}},
                    Mistake{"UnknownTeamAsFactor",
                            changed(kCorrectSweep, "b.robots: [6, 5]", "a.strategy: [basic, zon]"),
                            "x.yaml:6:32: a.strategy: expected one of ",
                            {"found 'zon'; did you mean 'zone'?"}},
                    Mistake{"UnknownParameterAsFactor",
                            changed(kCorrectSweep, "b.robots: [6, 5]", "a.params.shot: [5]"),
                            "x.yaml:6:12: teams.a.params.shot: ",
                            {"did you mean 'shot_mps' or 'shot_lane_m'?"}},
                    Mistake{"UnknownCamera",
                            changed(kCorrectSweep, "match: { half_s: 60 }",
                                    "sim: { camera: realistc }"),
                            "x.yaml:5:24: sim.camera: expected a file such as ",
                            {"did you mean 'realistic'?"}},
                    Mistake{"UnknownRules",
                            changed(kCorrectSweep, "half_s: 60", "rules: 2015"),
                            "x.yaml:5:25: match.rules: expected one of paper, 2014",
                            {"found '2015'"}},
                    Mistake{"NegativeTime",
                            changed(kCorrectSweep, "60", "-60"),
                            "x.yaml:5:26: match.half_s: expected a number above 0",
                            {"s, found '-60'"}},
                    Mistake{"NoMapping",
                            changed(kCorrectSweep, "{ half_s: 60 }", "60"),
                            "x.yaml:5:16: match: expected a mapping (",
                            {"half_s", "found '60'"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    RoundRobins, Mistakes,
    testing::Values(
        Mistake{"MissingTeams",
                changed(kCorrectRobin,
                        "teams: { bold: { strategy: basic }, calm: { strategy: zone } }\n", ""),
                "x.yaml:1:1: the key 'teams' is missing",
                {"such as teams: { one: { strategy: basic }"}},
        Mistake{"OneTeam",
                changed(kCorrectRobin, ", calm: { strategy: zone }", ""),
                "x.yaml:5:1: teams: expected at least 2 teams",
                {"found 1"}},
        Mistake{"NameOfATeam",
                changed(kCorrectRobin, "bold", "b~old"),
                "x.yaml:5:10: teams: a team's name must consist of letters",
                {"'b~old'"}},
        Mistake{"UnknownTeam",
                changed(kCorrectRobin, "zone", "zoen"),
                "x.yaml:5:55: teams.calm.strategy: expected one of ",
                {"found 'zoen'; did you mean 'zone'?"}},
        Mistake{"TeamsInTheBase",
                kCorrectRobin + "base: { teams: { a: {} } }\n",
                "x.yaml:6:9: base.teams: ",
                {"outside the base"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Games, Mistakes,
    testing::Values(Mistake{"ThirdTeam",
                            changed(kCorrectGame, "b: {", "c: {"),
                            "x.yaml:3:34: teams: unknown key 'c'. Known here: a, b",
                            {}},
                    Mistake{"UnknownParameter",
                            changed(kCorrectGame, "strategy: basic", "params: { shot_mp: 5 }"),
                            "x.yaml:3:25: teams.a.params.shot_mp: ",
                            {"did you mean 'shot_mps'?"}},
                    Mistake{
                        "ParameterOutOfRange",
                        changed(kCorrectGame, "strategy: basic", "params: { shot_mps: 9 }"),
                        "x.yaml:3:25: teams.a.params.shot_mps: expected a number from 0 to 8 m/s",
                        {"found '9'"}},
                    Mistake{"FileOfATypeThatIsNotThere",
                            changed(kCorrectGame, "strategy: basic", "type: robots/swift.yaml"),
                            "x.yaml:3:21: teams.a.type: ",
                            {"robots/swift.yaml", "cannot be read"}},
                    Mistake{"YesForTrue",
                            changed(kCorrectGame, "half_s: 60", "knockout: yes"),
                            "x.yaml:4:34: match.knockout: expected one of false, true",
                            {"found 'yes'"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(Syntax, Mistakes,
                         testing::Values(Mistake{"Tab",
                                                 changed(kCorrectSweep, "{ match: { half_s: 60 } }",
                                                         "\n\tmatch: { half_s: 60 }"),
                                                 "x.yaml:6:1: invalid YAML: this line",
                                                 {"use spaces"}},
                                         Mistake{"OpenBracket",
                                                 changed(kCorrectSweep, "5] }", "5 }"),
                                                 "x.yaml:6:28: invalid YAML: ",
                                                 {"bracket before it is not closed"}},
                                         Mistake{"OpenBrace",
                                                 changed(kCorrectSweep, "60 } }", "60 }"),
                                                 "x.yaml:6:1: invalid YAML: ",
                                                 {"'{' before here is not closed"}},
                                         Mistake{"ColonInText",
                                                 kCorrectSweep + "about: first: a test\n",
                                                 "x.yaml:7:13: invalid YAML: ",
                                                 {"in quotes"}},
                                         Mistake{"OpenQuotes",
                                                 kCorrectSweep + "about: \"a test\n",
                                                 "x.yaml:7:8: invalid YAML: ",
                                                 {"never closed"}},
                                         Mistake{"Indentation",
                                                 changed(kCorrectSweep, "{ match: { half_s: 60 } }",
                                                         "\n    match: {}\n  sim: {}"),
                                                 "x.yaml:7:3: invalid YAML: ",
                                                 {"indent this line like"}},
                                         Mistake{"TwoDocuments",
                                                 kCorrectSweep + "---\nschema: 1\n",
                                                 "x.yaml:8:1: expected one document",
                                                 {"leave out the line ---"}}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
