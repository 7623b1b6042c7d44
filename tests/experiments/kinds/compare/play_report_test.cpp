// What the new team does differently, as text.
#include "experiments/kinds/compare/play_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/table.hpp"

namespace autoref::experiments {
namespace {

PlayDifference difference(const std::string& name, double of_new, double of_old, double p) {
  const double mean = of_new - of_old;
  return {name, of_new, of_old, mean, Interval{mean - 0.5, mean + 0.5}, p / 17, p};
}

std::vector<PlayDifference> some_differences() {
  return {difference("chains from corner kicks", 0, 4.52, 1e-6),
          difference("passes tried", 20, 12.25, 1e-9), difference("fouls", 5, 6, 0.2)};
}

TEST(PlayReport, NamesTheMostCertainDifference) {
  EXPECT_EQ(most_certain_text(some_differences()),
            "Most certain difference in play: passes tried, 20.00 per game instead of 12.25.");
  EXPECT_EQ(most_certain_text(std::vector<PlayDifference>{difference("fouls", 5, 6, 0.2)}),
            "No difference in play is certain.");
}

TEST(PlayReport, HasOnlyCertainDifferencesInTheTable) {
  const std::string text = io::text_of(play_table(some_differences()), 1000);
  const std::size_t passes = text.find("passes tried");
  const std::size_t corners = text.find(
      "chains from corner kicks    0.00    4.52   -4.52 [-5.02, "
      "-4.02]\n");
  EXPECT_NE(corners, std::string::npos) << text;
  EXPECT_LT(passes, corners);
  EXPECT_EQ(text.find("fouls"), std::string::npos);
}

TEST(PlayReport, HasNoTableIfNothingIsCertain) {
  EXPECT_TRUE(play_table({difference("fouls", 5, 6, 0.2)}).empty());
}

TEST(PlayReport, HasAllDifferencesInFilesAndJson) {
  EXPECT_NE(play_csv(some_differences()).find("\nfouls,5.0000,6.0000,-1.0000,-1.5000,-0.5000,"),
            std::string::npos)
      << play_csv(some_differences());
  const io::Json json = play_json(some_differences());
  ASSERT_EQ(json.size(), 3U);
  EXPECT_EQ(json[0]["count"], "chains from corner kicks");
  EXPECT_EQ(json[0]["diff"], -4.52);
  EXPECT_EQ(json[2]["p_holm"], 0.2);
}

}  // namespace
}  // namespace autoref::experiments
