// `log compare`.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/errors.hpp"
#include "logs/compare/measures.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/has_part.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

class LogCompareVerb : public testing::Test {
 protected:
  void SetUp() override {
    for (const auto& [log, seed] : {std::pair(&recorded_, "1"), std::pair(&simulated_, "2")}) {
      const Answer answer =
          answer_to("play", {game_.c_str(), "--seed", seed, "--log", log->c_str(), "--set",
                             "match.rules=2026-b", "--set", "match.half_s=30"});
      ASSERT_EQ(answer.code, io::kDone) << answer.err;
    }
  }

  Answer compare(std::vector<const char*> more = {}) {
    more.insert(more.begin(), {recorded_.c_str(), "--with", simulated_.c_str()});
    return answer_to("log compare", more);
  }

  TemporaryFolder folder_;
  std::string game_ = in_checkout("scenarios/paper-game.yaml");
  std::string recorded_ = folder_ / "recorded.log";
  std::string simulated_ = folder_ / "simulated.log";
  std::string page_ = folder_ / "page.html";
};

TEST_F(LogCompareVerb, PrintsAllMeasuresAndTheirMean) {
  const Answer answer = compare();
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  for (const logs::MeasureEntry& entry : logs::kMeasures)
    EXPECT_TRUE(has(answer.out, std::string(entry.name) + " ")) << entry.name << answer.out;
  EXPECT_TRUE(has(answer.out, "Recorded: 1 log, ")) << answer.out;
  EXPECT_TRUE(has(answer.out, "mean of ")) << answer.out;
}

TEST_F(LogCompareVerb, JsonHasTheSameNumbers) {
  const auto json = nlohmann::json::parse(compare({"--json"}).out);
  ASSERT_EQ(json["measures"].size(), logs::kMeasureCount);
  EXPECT_EQ(json["measures"][0]["measure"], "ball_speed");
  EXPECT_GE(json["measures"][0]["recorded"]["values"], 1000);
  ASSERT_TRUE(json["distance"].is_number() && json["low"].is_number());
  EXPECT_GE(json["distance"], json["low"]);
  EXPECT_EQ(json["recorded"]["logs"], 1);
}

TEST_F(LogCompareVerb, WritesAPageWithTheDistributions) {
  const Answer answer = compare({"-o", page_.c_str()});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(has(answer.out, page_)) << answer.out;
  const std::string page = content_of(page_);
  EXPECT_TRUE(has(page, "robot_speed in m/s") || has(answer.err, "gnuplot")) << answer.err;
  EXPECT_TRUE(has(page, "<td class=\"name\">ball_unseen</td>"));
}

TEST_F(LogCompareVerb, KeepsItsInputs) {
  const std::string before = content_of(simulated_);
  const Answer answer = compare({"-o", simulated_.c_str()});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_EQ(content_of(simulated_), before);
}

TEST_F(LogCompareVerb, SkipsAFileThatIsNotALog) {
  const std::string other = folder_ / "other.log";
  write_content(other, "not a log");
  const Answer both = compare({other.c_str()});
  EXPECT_EQ(both.code, io::kBadInput);
  EXPECT_TRUE(has(both.out, "Simulated: 1 log, ")) << both.out;
  const Answer none = answer_to("log compare", {recorded_.c_str(), "--with", other.c_str()});
  EXPECT_EQ(none.code, io::kBadInput);
  EXPECT_EQ(none.out, "");
  EXPECT_TRUE(has(none.err, "other.log")) << none.err;
}

}  // namespace
}  // namespace autoref::app
