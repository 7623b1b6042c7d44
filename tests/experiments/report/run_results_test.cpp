#include "experiments/report/run_results.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/knockout/knockout.hpp"
#include "experiments/run/result_folder.hpp"
#include "tests/experiments/run/fake_games.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

std::string shown_after_a_run(const Scenario& scenario) {
  const TemporaryFolder folder;
  std::string html;
  ExperimentOptions options = fake_options(folder.path());
  options.publish = [](const io::GameCounts&, const std::string&) {};
  options.show = [&](const ExperimentResults& results) { html = run_results_html(results); };
  run_experiment(scenario, options);
  return html;
}

TEST(RunResults, OfATournamentAreStandingsWithIntervalsAndTheReportsCrosstable) {
  const std::string html = shown_after_a_run(small_roundrobin({6, 16}, 2));
  EXPECT_TRUE(has(html, "<h2>Standings</h2>")) << html;
  EXPECT_TRUE(has(html, "<td class=\"name\">1.\u00a0team1</td>")) << html;
  EXPECT_TRUE(has(html, "rating in goals [95 %]")) << html;
  EXPECT_TRUE(has(html, "<h2>Crosstable</h2>")) << html;
  EXPECT_TRUE(has(html, "All intervals are 95 % confidence intervals.")) << html;
}

// The only game must be in what is shown at the end.
TEST(RunResults, OfACupAreItsBracket) {
  Knockout knockout;
  knockout.order = {"team0", "team1"};
  knockout.teams["team0"].robots = 6;
  knockout.teams["team1"].robots = 5;
  const std::string html = shown_after_a_run({"A cup.", knockout});
  EXPECT_TRUE(has(html, "has-won")) << html;
  EXPECT_TRUE(has(html, "class=\"bracket\"")) << html;
  EXPECT_TRUE(has(html, "the winner is team")) << html;
}

TEST(RunResults, OfOtherKindsAreTheirTables) {
  const std::string html = shown_after_a_run(small_sweep());
  EXPECT_TRUE(has(html, "<h2>Results</h2>")) << html;
  EXPECT_TRUE(has(html, "b.robots")) << html;
}

TEST(RunResults, AreOfLimitedLength) {
  ExperimentResults results;
  io::TextTable table{{{"value", "games"}}};
  for (int i = 0; i < 100'000; ++i) table.rows.push_back({std::to_string(i), "1"});
  results.table = {table};
  const std::string html = run_results_html(results);
  EXPECT_LT(html.size(), 20'000U);
  EXPECT_TRUE(has(html, "<p>and 99800 more</p>")) << html;
}

TEST(RunResults, NeverContainMarkupOfNames) {
  ExperimentResults results;
  results.table = {io::TextTable{{{"<img src=x onerror=alert(1)>"}}}, "<script>"};
  results.ties = {{"final",
                   BracketPlace{},
                   {{{"<b>", true, "<i>", false}, {"\"><u>", false, "", false}}},
                   "<s>"}};
  const std::string html = run_results_html(results);
  for (const char* const tag : {"<img", "<script", "<b>", "<i>", "<u>", "<s>"})
    EXPECT_FALSE(has(html, tag)) << tag;
}

}  // namespace
}  // namespace autoref::experiments
