#include <gtest/gtest.h>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/tune/tuning.hpp"
#include "experiments/kinds/tune/tuning_schedule.hpp"
#include "tests/experiments/reading/mistake.hpp"

namespace autoref::experiments {
namespace {

const std::string kTuneTop = "schema: 1\nkind: tune\nseed: 7\n";
const std::string kTuneTeam = "team: { strategy: cobalt, params: { width: 0.5 } }\n";
const std::string kTuneNumbers = "iterations: 10\npairs: 2\n";

Tuning read_tune(const std::string& text, const game::Assignments& assignments = {}) {
  return *read_scenario_text(kTuneTop + kTuneTeam + kTuneNumbers + text, "x.yaml", assignments)
              .as<Tuning>();
}

TEST(ReadTuning, TakesDefaultsFromTheStrategyAndTheTeam) {
  const Tuning tuning = read_tune("tune: { pass_risk: {}, width: {} }\n");
  ASSERT_EQ(tuning.parameters.size(), 2U);
  const TunedParameter& risk = tuning.parameters[0];
  EXPECT_EQ(risk.from, 0);
  EXPECT_EQ(risk.to, 1);
  EXPECT_GT(risk.start, 0);
  EXPECT_DOUBLE_EQ(risk.step, 0.2);
  EXPECT_EQ(tuning.parameters[1].start, 0.5);  // the team's value
  EXPECT_TRUE(tuning.is_against_itself());
}

TEST(ReadTuning, PlaysWholeNumbersOnlyIfAsked) {
  const Tuning tuning = read_tune("tune: { wall: { from: 1, to: 4, start: 2, whole: true } }\n");
  EXPECT_DOUBLE_EQ(tuning.parameters.front().step, 1);
  for (const ScheduledGame& game : tuning.games()) {
    const double wall = game.settings.combined().a.params.at("wall");
    EXPECT_EQ(wall, static_cast<int>(wall));
  }
}

TEST(ReadTuning, PlaysOnlyZeroAndOneOfAFlag) {
  const Tuning tuning = read_tune("tune: { around_boxes: {} }\n");
  const TunedParameter& flag = tuning.parameters.front();
  EXPECT_TRUE(flag.whole);
  EXPECT_EQ(flag.from, 0);
  EXPECT_EQ(flag.to, 1);
  EXPECT_EQ(flag.start, 1);
  EXPECT_EQ(flag.step, 1);
}

TEST(ReadTuning, ChangesTheTeamAndItsOpponentsFromTheCommandLine) {
  const game::Assignments assignments =
      game::assignments_in({"team.robots=5", "opponents.zone.robots=4"});
  const Tuning tuning =
      read_tune("tune: { pass_risk: {} }\nopponents: { zone: { strategy: zone } }\n", assignments);
  EXPECT_EQ(tuning.team.robots, 5);
  EXPECT_EQ(tuning.opponents.at("zone").robots, 4);
  for (const char* set : {"a.robots=5", "team.params.pass_risk=0.3", "opponents.zone.robots=4"}) {
    EXPECT_THROW(read_tune("tune: { pass_risk: {} }\n", game::assignments_in({set})),
                 io::InputError)
        << set;
  }
}

TEST(EffectiveConfiguration, OfATuningReadsBackEqual) {
  for (const char* more :
       {"opponents: self\n", "method: cma-es\n", "gain: 0.3\n",
        "opponents: { zone: { strategy: zone }, b: { robots: 5 } }\nweights: { zone: 2.5 }\n"}) {
    Tuning tuning = read_tune(std::string("tune: { pass_risk: { step: 0.1 }, wall: { whole: true "
                                          "} }\ntest: { delta: 0.3, max_pairs: 50 }\n") +
                              more);
    const std::string text = effective_text({"A test.", tuning});
    EXPECT_EQ(effective_text(read_scenario_text(text, "x.yaml")), text);
  }
}

class WrongTuning : public testing::TestWithParam<Mistake> {};

TEST_P(WrongTuning, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

std::string with(const std::string& text) { return kTuneTop + kTuneTeam + kTuneNumbers + text; }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongTuning,
    testing::Values(
        Mistake{"UnknownKey",
                with("tune: { pass_risk: {} }\nopponent: self\n"),
                "x.yaml:8:1: ",
                {"unknown key 'opponent'", "did you mean 'opponents'?"}},
        Mistake{"UnknownParameter",
                with("tune: { pass_riks: {} }\n"),
                "x.yaml:7:9: tune: ",
                {"unknown key 'pass_riks'", "did you mean 'pass_risk'?"}},
        Mistake{
            "NothingToTune", with("tune: {}\n"), "x.yaml:7:1: tune: ", {"expected a parameter"}},
        Mistake{"StartOutside",
                with("tune: { width: { from: 0.6, to: 0.9 } }\n"),
                "x.yaml:7:9: ",
                {"tune.width.start is 0.5; it must be from 0.6 to 0.9"}},
        Mistake{"RangeTooLarge",
                with("tune: { pass_risk: { to: 2 } }\n"),
                "x.yaml:7:22: ",
                {"tune.pass_risk.to", "expected a number from 0 to 1"}},
        Mistake{"StepTooLarge",
                with("tune: { pass_risk: { step: 2 } }\n"),
                "x.yaml:7:22: ",
                {"tune.pass_risk.step is 2; it must be above 0 and at most the range, 1"}},
        Mistake{"NotWhole",
                with("tune: { wall: { start: 1.5, whole: true } }\n"),
                "x.yaml:7:17: ",
                {"tune.wall.start is 1.5; this parameter needs a whole number"}},
        Mistake{"BetweenZeroAndOne",
                with("tune: { around_boxes: { whole: false } }\n"),
                "x.yaml:7:25: tune.around_boxes.whole: ",
                {"can only be 0 or 1"}},
        Mistake{"StartBetweenZeroAndOne",
                with("tune: { around_boxes: { start: 0.5 } }\n"),
                "x.yaml:7:25: ",
                {"tune.around_boxes.start is 0.5; this parameter needs a whole number"}},
        Mistake{"UnknownMethod",
                with("tune: { wall: {} }\nmethod: cma\n"),
                "x.yaml:8:9: method: ",
                {"spsa, cma-es"}},
        Mistake{"GainOfCmaEs",
                with("tune: { wall: {} }\nmethod: cma-es\ngain: 1\n"),
                "x.yaml:9:1: gain: ",
                {"only applies to method spsa"}},
        Mistake{"WeightsWithoutOpponents",
                with("tune: { wall: {} }\nweights: { zone: 1 }\n"),
                "x.yaml:8:1: weights: ",
                {"the file has no opponents"}},
        Mistake{"WeightOfNobody",
                with("tune: { wall: {} }\nopponents: { zone: {} }\nweights: { zoen: 1 }\n"),
                "x.yaml:9:12: weights: ",
                {"did you mean 'zone'?"}},
        Mistake{"OpponentWithATakenName",
                with("tune: { wall: {} }\nopponents: { plus: {} }\n"),
                "x.yaml:8:14: ",
                {"opponents.plus", "choose another"}},
        Mistake{"TestWithoutPairs",
                with("tune: { wall: {} }\ntest: { max_pairs: 5 }\n"),
                "x.yaml:8:9: ",
                {"test.max_pairs: must be at least min_pairs, which is 10; found 5"}},
        Mistake{"TooManyGames",
                kTuneTop + kTuneTeam + "iterations: 9999\npairs: 99\ntune: { wall: {} }\n",
                "x.yaml:5:1: ",
                {"iterations: these settings amount to"}},
        Mistake{"ProgramWithoutStart",
                kTuneTop + kTuneNumbers +
                    "team: { command: [./x] }\ntune: { k: { from: 0, to: 1 } "
                    "}\n",
                "x.yaml:7:9: tune.k: ",
                {"the key 'start' is missing"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
