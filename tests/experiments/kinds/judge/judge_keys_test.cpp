// Teams and seeds of `kind: judge`.
#include "experiments/kinds/judge/judge_schedule.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/scenario_reader.hpp"
#include "tests/experiments/reading/mistake.hpp"

namespace autoref::experiments {
namespace {

// Lines 1 to 4, then those given.
std::string file_with(const std::string& lines) {
  return "schema: 1\nkind: judge\ncameras: [none]\ngames: 4\n" + lines;
}

JudgeSchedule judge_read_from(const std::string& lines) {
  return *read_scenario_text(file_with(lines), "x.yaml").as<JudgeSchedule>();
}

TEST(JudgeReader, ReadsNamedSeedsAlsoFromACommit) {
  const JudgeSchedule schedule = judge_read_from("seeds: { test: 1c9f03ae, tuning: 2016 }\n");
  const std::vector<NamedSeed> expected = {{"tuning", "2016", 2016},
                                           {"test", "1c9f03ae", 0x1c9f03ae}};
  EXPECT_EQ(schedule.seeds, expected);
  EXPECT_EQ(text_of(schedule.seeds), "tuning 2016, test 1c9f03ae (480183214)");
}

// A commit may begin with what looks like a number.
TEST(JudgeReader, ReadsDigitsAsADecimalNumberAndOneLetterAsHexadecimal) {
  EXPECT_EQ(judge_read_from("seeds: { test: 12345678 }\n").seeds.front().value, 12345678U);
  EXPECT_EQ(judge_read_from("seeds: { test: 12345e67 }\n").seeds.front().value, 0x12345e67U);
}

TEST(JudgeReader, ReadsASingleSeedWithoutName) {
  const std::vector<NamedSeed> expected = {{"", "7", 7}};
  EXPECT_EQ(judge_read_from("seed: 7\n").seeds, expected);
}

TEST(JudgeReader, ReadsTeams) {
  const std::vector<std::string> expected = {"rowdy", "basic"};
  EXPECT_EQ(judge_read_from("teams: [rowdy, basic]\nseed: 7\n").teams, expected);
}

TEST(JudgeReader, ReadsTeamsAndSeedsBackFromTheEffectiveFile) {
  const Scenario scenario = read_scenario_text(
      file_with("teams: [rowdy, basic]\nseeds: { tuning: 7, test: 12345e67 }\n"), "x.yaml");
  const std::string text = effective_text(scenario);
  EXPECT_NE(text.find("seeds:\n  tuning: 7\n  test: 12345e67\n"), std::string::npos) << text;
  EXPECT_EQ(effective_text(read_scenario_text(text, "effective.yaml")), text);
}

TEST(JudgeReader, ReadsABaseWithAPresetBackFromTheEffectiveFile) {
  const Scenario scenario = read_scenario_text(
      file_with(
          "rules: [paper, 2026-b]\nseed: 7\nbase: { sim: { dribbler: { preset: perfect } } }\n"),
      "x.yaml");
  const std::string text = effective_text(scenario);
  EXPECT_EQ(effective_text(read_scenario_text(text, "effective.yaml")), text);
}

class JudgeMistake : public testing::TestWithParam<Mistake> {};

TEST_P(JudgeMistake, IsRefused) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Keys, JudgeMistake,
    testing::Values(
        Mistake{"both_seeds",
                file_with("seed: 7\nseeds: { test: 8 }\n"),
                "x.yaml:6:1",
                {"seeds", "the file also has 'seed'"}},
        Mistake{"no_seed", file_with(""), "x.yaml", {"seed"}},
        Mistake{"no_named_seed", file_with("seeds: {}\n"), "x.yaml:5:8", {"tuning: 1, test: 2"}},
        Mistake{"unknown_seed",
                file_with("seeds: { tests: 8 }\n"),
                "x.yaml:5:10",
                {"tests", "did you mean 'test'?"}},
        Mistake{"equal_seeds",
                file_with("seeds: { tuning: 8, test: 8 }\n"),
                "x.yaml:5:27",
                {"seeds.test", "equals the other seed"}},
        Mistake{"short_commit",
                file_with("seeds: { test: 1c9f03a }\n"),
                "x.yaml:5:16",
                {"seeds.test", "the first eight hexadecimal digits of a commit", "'1c9f03a'"}},
        Mistake{"not_hexadecimal",
                file_with("seeds: { test: 1c9f03ag }\n"),
                "x.yaml:5:16",
                {"seeds.test", "'1c9f03ag'"}},
        Mistake{"negative_seed", file_with("seeds: { test: -1 }\n"), "x.yaml:5:16", {"'-1'"}},
        Mistake{"list_of_seeds", file_with("seeds: [1, 2]\n"), "x.yaml:5", {"seeds"}},
        Mistake{"teams_and_matchups",
                file_with("teams: [basic]\nmatchups: [basic~basic]\nseed: 7\n"),
                "x.yaml:5:1",
                {"teams", "the file also has 'matchups'"}},
        Mistake{"unknown_team",
                file_with("teams: [basic, bsaic]\nseed: 7\n"),
                "x.yaml:5:16",
                {"bsaic", "did you mean 'basic'?"}},
        Mistake{"team_twice",
                file_with("teams: [basic, basic]\nseed: 7\n"),
                "x.yaml:5:16",
                {"teams", "given twice"}},
        Mistake{"no_teams", file_with("teams: []\nseed: 7\n"), "x.yaml:5:8", {"teams"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
