// The texts of `autoref compare --ci`.
#include "app/experiment/ci_report.hpp"

#include <gtest/gtest.h>

#include "io/table.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::app {
namespace {

using experiments::ThreeWayVerdict;

CiReport report_of(ThreeWayVerdict verdict, const char* required = kDefaultRequirement) {
  CiReport report;
  report.name = "autoref compare basic 'a|b.py'";
  report.about = "Is new better than old? new: <b>`x`";
  report.answer = {verdict,
                   "the answer",
                   "Most certain part: saves.",
                   {io::TextTable{{{"against", "games"}, {"each other", "8"}}, {io::Align::kLeft}}},
                   {"Where it comes from:\n\n",
                    io::TextTable{{{"part", "goals"}, {"saves", "1 *"}}, {io::Align::kLeft}}},
                   {"What new does differently:\n\n",
                    io::TextTable{{{"per game", "new"}, {"shots", "3.00"}}, {io::Align::kLeft}}}};
  report.requirement = requirement_of(required);
  report.games = 8;
  report.rules = "2026-b";
  report.seed = "7";
  report.build = "1.0.0-test";
  report.command = "autoref compare basic 'a|b.py' --seed 7";
  return report;
}

experiments::GameRow void_row(const std::string& id, const std::string& reason) {
  experiments::GameRow row;
  row.game_id = id;
  row.team_a = "new";
  row.team_b = "old";
  row.record = experiments::void_record(reason);
  return row;
}

TEST(CiReport, SaysInBoldWhetherTheRequirementIsMet) {
  const auto markdown = [](ThreeWayVerdict verdict, const char* required) {
    return comparison_markdown(report_of(verdict, required));
  };
  EXPECT_TRUE(has(markdown(ThreeWayVerdict::kBetter, "better"), "\n**Passed: the answer**\n"));
  EXPECT_TRUE(has(markdown(ThreeWayVerdict::kNotShown, "better"), "\n**Failed: the answer**\n"));
  EXPECT_TRUE(has(markdown(ThreeWayVerdict::kNotShown, "equal"), "\n**Passed: the answer**\n"));
  EXPECT_TRUE(has(markdown(ThreeWayVerdict::kUndecided, "not-worse"), "\n**Passed: the answer**"));
  EXPECT_TRUE(has(markdown(ThreeWayVerdict::kUndecided, "equal"), "\n**Failed: the answer**"));
  EXPECT_TRUE(has(markdown(ThreeWayVerdict::kWorse, "not-worse"), "\n**Failed: the answer**"));
}

TEST(CiReport, ShowsTheOpponentsAndFoldsTheParts) {
  const std::string text = comparison_markdown(report_of(ThreeWayVerdict::kBetter));
  EXPECT_TRUE(text.starts_with("# autoref compare basic 'a\\|b.py'\n")) << text;
  EXPECT_TRUE(has(text, "\n| against | games |\n|---|--:|\n| each other | 8 |\n")) << text;
  EXPECT_TRUE(
      has(text,
          "\n<details><summary>Where it comes from</summary>\n\n| part | goals |\n|---|--:|\n"
          "| saves | 1 \\* |\n\n</details>\n"))
      << text;
}

TEST(CiReport, SaysHowToRepeatTheComparison) {
  const std::string text = comparison_markdown(report_of(ThreeWayVerdict::kBetter));
  EXPECT_TRUE(has(text, "\n- rules: 2026-b\n- seed: 7\n- build: autoref 1.0.0-test\n")) << text;
  EXPECT_TRUE(has(text, "\n```\nautoref compare basic 'a|b.py' --seed 7\n```\n")) << text;
}

TEST(CiReport, EscapesTeams) {
  const CiReport report = report_of(ThreeWayVerdict::kWorse);
  EXPECT_TRUE(has(comparison_markdown(report), "new: \\<b\\>\\`x\\`"));
  EXPECT_TRUE(has(comparison_junit(report), "new: &lt;b&gt;`x`"));
}

TEST(CiReport, HasATestForTheRequirement) {
  const std::string passed = comparison_junit(report_of(ThreeWayVerdict::kUndecided));
  EXPECT_TRUE(has(passed, "tests=\"1\" failures=\"0\" errors=\"0\"")) << passed;
  EXPECT_TRUE(has(passed, "<system-out>the answer\n")) << passed;
  const std::string failed = comparison_junit(report_of(ThreeWayVerdict::kUndecided, "better"));
  EXPECT_TRUE(has(failed, "name=\"new is better than old\"")) << failed;
  EXPECT_TRUE(has(failed, "<failure message=\"the answer\">the answer\n")) << failed;
}

TEST(CiReport, HasATestForEachReasonOfVoidGames) {
  CiReport report = report_of(ThreeWayVerdict::kBetter);
  report.problems =
      void_problems({{"g1", void_row("g1", "team a ended with status 1 (at 2.5 s)")},
                     {"g2", void_row("g2", "the game threw: x")},
                     {"g3", void_row("g3", "team a ended with status 1 (at 9.0 s)")}});
  const std::string xml = comparison_junit(report);
  EXPECT_TRUE(has(xml, "tests=\"3\" failures=\"0\" errors=\"2\"")) << xml;
  EXPECT_TRUE(has(xml, "name=\"team new ended with status 1\"")) << xml;
  EXPECT_TRUE(has(xml, "2 of 8 games are void: team new ended with status 1 (g1, g3)")) << xml;
  EXPECT_TRUE(
      has(comparison_markdown(report), "\n- 1 of 8 games are void: the game threw: x (g2)"));
}

TEST(CiReport, HasNoAnswerIfTooManyGamesAreVoid) {
  CiReport report = report_of(ThreeWayVerdict::kBetter);
  report.has_too_many_void = true;
  report.problems = {{"team new ended with status 1", {"g1", "g2"}}};
  EXPECT_TRUE(has(comparison_markdown(report), "**Failed: 2 of 8 games are void, more than 5 %"));
  EXPECT_TRUE(has(comparison_junit(report), "<error message=\"2 of 8 games are void"));
}

}  // namespace
}  // namespace autoref::app
