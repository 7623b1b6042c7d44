// The parts of a comparison's difference as text.
#include "experiments/kinds/compare/parts_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/table.hpp"

namespace autoref::experiments {
namespace {

DifferencePart part(const std::string& name, double mean, double half_width, double p_holm = 1) {
  DifferencePart part;
  part.name = name;
  part.of_new = 0.5 + mean;
  part.of_old = 0.5;
  part.each_other = mean;
  part.mean = mean;
  part.interval = Interval{mean - half_width, mean + half_width};
  part.p = p_holm / 15;
  part.p_holm = p_holm;
  return part;
}

DifferenceParts some_parts() {
  DifferencePart nothing;
  nothing.name = "chances from penalties";
  return {{part("chances from corner kicks", -0.16, 0.06, 0.001), nothing},
          {part("chances with a pass", -0.16, 0.2)},
          part("chances in all", -0.16, 0.1, 0.001),
          {part("saves", 0.05, 0.054)},
          part("goals", -0.11, 0.3)};
}

std::string text_of(const DifferenceParts& parts, bool has_opponents = false) {
  return io::text_of(parts_table(parts, has_opponents), 1000);
}

TEST(PartsReport, NamesTheMostCertainPart) {
  EXPECT_EQ(most_certain_text(some_parts()),
            "Most certain part of the difference: chances from corner kicks, -0.16 goals per game "
            "[-0.22, "
            "-0.10].");
}

TEST(PartsReport, SaysThatNoPartIsCertain) {
  DifferenceParts parts = some_parts();
  parts.by_start[0].p = 0.06;
  parts.by_start[0].p_holm = 0.9;
  EXPECT_EQ(most_certain_text(parts), "No single part of the difference is certain.");
  EXPECT_EQ(most_certain_text({}), "No single part of the difference is certain.");
}

TEST(PartsReport, NamesAPartThatOnlyTheCorrectionMakesUncertain) {
  DifferenceParts parts = some_parts();
  parts.by_start[0].p = 0.0133;
  parts.by_start[0].p_holm = 0.2;
  EXPECT_EQ(
      most_certain_text(parts),
      "No single part of the difference is certain. The strongest candidate: chances from corner "
      "kicks, -0.16 goals per game [-0.22, -0.10]; p = 0.2, corrected for the number of "
      "parts.");
}

TEST(PartsReport, MarksCertainPartsButNotSums) {
  const std::string text = text_of(some_parts());
  EXPECT_NE(text.find("-0.16 [-0.22, -0.10] *\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("-0.16 [-0.26, -0.06] *"), std::string::npos) << text;
}

TEST(PartsReport, LeavesOutPartsThatAreZero) {
  EXPECT_EQ(text_of(some_parts()).find("penalties"), std::string::npos);
  EXPECT_NE(parts_csv(some_parts()).find("penalties"), std::string::npos);
}

TEST(PartsReport, GivesNumbersNearZeroAThirdDecimal) {
  EXPECT_NE(text_of(some_parts()).find("+0.05 [-0.004, +0.10]"), std::string::npos);
}

TEST(PartsReport, HasOnlyTheMeanWithoutAnInterval) {
  DifferenceParts parts = some_parts();
  parts.others[0].interval.reset();
  EXPECT_NE(text_of(parts).find(" +0.05\n"), std::string::npos) << text_of(parts);
}

TEST(PartsReport, SaysWhereADifferenceAgainstOpponentsComesFrom) {
  DifferenceParts parts = some_parts();
  parts.others[0].each_other = 0.01;
  parts.others[0].defence = 0.04;
  const std::string text = text_of(parts, true);
  EXPECT_NE(text.find("each other   attack   defence"), std::string::npos) << text;
  EXPECT_NE(text.find("+0.01    +0.00     +0.04"), std::string::npos) << text;
}

TEST(PartsReport, HasAllPartsInJson) {
  const io::Json json = parts_json(some_parts());
  ASSERT_EQ(json.size(), 6U);
  EXPECT_EQ(json[0]["part"], "chances from corner kicks");
  EXPECT_EQ(json[0]["diff"], -0.16);
  EXPECT_EQ(json[0]["p_holm"], 0.001);
  EXPECT_TRUE(json[1]["diff_low95"].is_null());
  EXPECT_EQ(json[5]["part"], "goals");
}

}  // namespace
}  // namespace autoref::experiments
