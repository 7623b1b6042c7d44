#include "experiments/report/plots.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "experiments/kinds/gauntlet/gauntlet.hpp"
#include "experiments/report/running_mean.hpp"
#include "io/files.hpp"
#include "tests/checkout.hpp"
#include "tests/experiments/run/fake_games.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

// Results of fake games.
ExperimentResults played_fakes(const Scenario& scenario) {
  const TemporaryFolder folder;
  return run_experiment(scenario, fake_options(folder.path())).results;
}

std::vector<std::string> names_of(const std::vector<Plot>& plots) {
  std::vector<std::string> names;
  for (const Plot& plot : plots) names.push_back(plot.name);
  return names;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(Plots, OfASweepOverNumbersAreCurvesAndHistograms) {
  EXPECT_EQ(names_of(plots_of(small_sweep(), played_fakes(small_sweep()))),
            (std::vector<std::string>{"scores", "difference", "histogram", "running_mean"}));
}

TEST(Plots, OfARoundRobinAreTablesAndRatings) {
  const Scenario robin = small_roundrobin({6, 5, 4});
  EXPECT_EQ(names_of(plots_of(robin, played_fakes(robin))),
            (std::vector<std::string>{"difference", "crosstable", "ratings", "histogram",
                                      "running_mean"}));
}

TEST(Plots, OfChallengersHaveNoRatings) {
  Gauntlet gauntlet;
  gauntlet.challengers["bold"].robots = 6;
  gauntlet.teams["zone"].robots = 5;
  const Scenario scenario{"A test.", gauntlet};
  EXPECT_EQ(names_of(plots_of(scenario, played_fakes(scenario))),
            (std::vector<std::string>{"difference", "histogram", "running_mean"}));
}

Group group_of_six_robots() {
  Group group;
  group.values = {"6"};
  return group;
}

TEST(Plots, AreEmptyBeforeTheFirstGame) {
  Group six = group_of_six_robots();
  six.void_games = 1;
  ExperimentResults results;
  results.groups = {six};
  EXPECT_TRUE(plots_of(small_sweep(), results).empty());
}

TEST(Plots, HaveNamedColumns) {
  const std::vector<Plot> plots = plots_of(small_sweep(), played_fakes(small_sweep()));
  ASSERT_EQ(plots.size(), 4U);
  EXPECT_EQ(first_line(plots[0].csv), "value,games,mean_a,sd_a,mean_b,sd_b");
  EXPECT_EQ(first_line(plots[1].csv), "value,pairs,mean_diff,low95,high95");
  EXPECT_EQ(first_line(plots[2].csv), "row,name,goal_difference,games,share_of_tallest");
  EXPECT_EQ(first_line(plots[3].csv), "panel,name,pairs,mean_diff,low95,high95");
}

TEST(ScoresPlot, HasTheBaselineOnTheLeft) {
  const std::optional<Plot> plot = scores_plot(small_sweep(), played_fakes(small_sweep()));
  EXPECT_TRUE(has(plot.value().script, "set xrange [6.06:4.94]")) << plot->script;
}

// gnuplot ends an axis at the next tic, which may be where the highest bar ends.
void expect_axis_of_goals(const std::string& script) {
  EXPECT_TRUE(has(script, "set yrange [0:*]\n")) << script;
  EXPECT_TRUE(has(script, "set offsets 0, 0, graph 0.04, 0")) << script;
  EXPECT_TRUE(has(script, "low(mean, deviation) = mean > deviation ? mean - deviation : 0\n"))
      << script;
}

TEST(ScoresPlot, BeginsAtNoGoalsAndHasRoomAboveTheHighestBar) {
  expect_axis_of_goals(scores_plot(small_sweep(), played_fakes(small_sweep())).value().script);
}

TEST(Figure5, BeginsAtNoGoalsAndHasRoomAboveTheHighestBar) {
  expect_axis_of_goals(io::read_file(in_checkout("results/figure5/figure5.gp")).value());
}

TEST(DifferencePlot, ShowsTheSlope) {
  const std::optional<Plot> plot = difference_plot(small_sweep(), played_fakes(small_sweep()));
  EXPECT_TRUE(has(plot.value().about, "Slope: ")) << plot->about;
  EXPECT_TRUE(has(plot->about, "goals per game per unit of b.robots")) << plot->about;
}

TEST(HistogramPlot, CountsTheGamesOfEachDifference) {
  Group six = group_of_six_robots();
  six.differences = {1, 1, -2};
  six.wins_a = 2;
  six.wins_b = 1;
  ExperimentResults results;
  results.groups = {six};
  EXPECT_EQ(histogram_plot(small_sweep(), results).value().csv,
            "row,name,goal_difference,games,share_of_tallest\n1,6,-2,1,0.5000\n1,6,1,2,1.0000\n");
}

TEST(RunningMeans, FollowTheNumbersOfPairs) {
  Group group;
  group.pair_differences = {{1, 1}, {10, 9}, {2, 2}};
  const std::vector<RunningMean> means = running_means(group);
  ASSERT_EQ(means.size(), 3U);
  EXPECT_DOUBLE_EQ(means[1].mean, 1.5);
  EXPECT_FALSE(means[0].interval);
  // Values 1 and 2: t(0.975, 1) = 12.7062 from tables, standard error 0.5.
  EXPECT_NEAR(means[1].interval.value().high, 1.5 + 12.7062 / 2, 1e-4);
}

TEST(CrosstablePlot, ShowsEachMatchupFromBothSides) {
  const Scenario robin = small_roundrobin({6, 16}, 1);
  const std::string csv = crosstable_plot(played_fakes(robin)).value().csv;
  EXPECT_EQ(line_count(csv), 3);
  EXPECT_TRUE(has(csv, "\n1,2,team1,team0,2,0,0,")) << csv;
  EXPECT_TRUE(has(csv, "\n2,1,team0,team1,0,0,2,-")) << csv;
}

ExperimentResults results_with_strength(double value, const Interval& interval) {
  Standing standing;
  standing.team = "bold";
  standing.is_rated = true;
  standing.strength = {"bold", value, interval};
  Group group;
  group.values = {"bold", "calm"};
  group.differences = {1};
  ExperimentResults results;
  results.groups = {group};
  results.standings = {standing};
  return results;
}

TEST(RatingsPlot, DrawsAnArrowToTheEdgeForAnOpenEnd) {
  const std::optional<Plot> plot =
      ratings_plot(results_with_strength(3, {1, std::numeric_limits<double>::infinity()}));
  EXPECT_TRUE(has(plot.value().csv, ",3.0000,1.0000,inf\n")) << plot->csv;
  // From 0 to 3, and 8 % of this on either side.
  EXPECT_TRUE(has(plot->script, "set xrange [-0.24:3.24]\n")) << plot->script;
  EXPECT_TRUE(has(plot->script, "with vectors")) << plot->script;
}

TEST(RatingsPlot, HasNoArrowsIfAllIntervalsHaveTwoEnds) {
  const std::optional<Plot> plot = ratings_plot(results_with_strength(3, {1, 4}));
  EXPECT_FALSE(has(plot.value().script, "with vectors")) << plot->script;
}

TEST(Plots, SayWhichGroupsTheyLeaveOut) {
  EXPECT_EQ(note_of_cut(45), "");
  EXPECT_EQ(note_of_cut(66), " Only the first 45 of 66 are drawn; the data file contains all.");
}

TEST(TicStep, DividesIntoAtMostFiveParts) {
  EXPECT_DOUBLE_EQ(tic_step(5), 1);
  EXPECT_DOUBLE_EQ(tic_step(9), 2);
  EXPECT_DOUBLE_EQ(tic_step(19), 5);
  EXPECT_DOUBLE_EQ(tic_step(0.45), 0.1);
}

TEST(ScriptText, IsNeverExecuted) { EXPECT_EQ(script_text("it's `x`\n$y"), "'it''s `x` $y'"); }

TEST(ScriptText, IsCutBetweenCharacters) {
  EXPECT_EQ(shortened("äöü", 3), "äöü");
  EXPECT_EQ(shortened("äöüß", 3), "äö…");
}

}  // namespace
}  // namespace autoref::experiments
