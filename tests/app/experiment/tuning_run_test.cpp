// Tests `autoref run` on a tuning, with games of a second.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

class TuningRun : public testing::Test {
 protected:
  void SetUp() override {
    write_content(file_,
                  "schema: 1\nkind: tune\nabout: A test.\n"
                  "team: { strategy: cobalt }\ntune: { pass_risk: {}, line_m: {} }\n"
                  "opponents: { idle: { strategy: dummy } }\n"
                  "base: { match: { rules: paper, half_s: 1 } }\n"
                  "iterations: 2\npairs: 1\ntest: { min_pairs: 2, max_pairs: 2 }\nseed: 1\n");
  }
  Answer tune(std::vector<const char*> further = {}) const {
    std::vector<const char*> words = {"run", file_.c_str(), "-o", results_.c_str(), "-j", "1"};
    words.insert(words.end(), further.begin(), further.end());
    return answer_to(words);
  }

  TemporaryFolder folder_;
  std::string file_ = (folder_ / "short.yaml").string();
  std::string results_ = (folder_ / "results").string();
};

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Two iterations of two candidates in two legs, and two pairs of the test, four games each.
TEST_F(TuningRun, SearchesTestsAndContinues) {
  const Answer answer = tune();
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(says(answer.err, "16/16 games")) << answer.err;
  EXPECT_TRUE(says(answer.out, "Gain over the start against idle")) << answer.out;
  EXPECT_TRUE(says(answer.out, "tune.csv   a row per iteration")) << answer.out;
  EXPECT_TRUE(says(content_of(folder_ / "results/result.yaml"), "\ntuned:\n  strategy: cobalt\n"));
  const Answer again = tune();
  EXPECT_TRUE(says(again.err, "16/16 games   0 void")) << again.err;
}

TEST_F(TuningRun, ExitsWithSeventyFiveIfAnotherShardsGamesDoNotCome) {
  const Answer answer = tune({"--shard", "0/2", "--wait", "0.1"});
  EXPECT_EQ(answer.code, io::kInterrupted);
  EXPECT_TRUE(says(answer.out, "the next ones depend on games of other shards")) << answer.out;
}

TEST_F(TuningRun, IsWhatTheFormerVerbPlays) {
  const Answer answer = answer_to(
      {"tune", file_.c_str(), "-o", results_.c_str(), "-j", "1", "--shard", "0/2", "--wait", "0"});
  EXPECT_EQ(answer.code, io::kInterrupted) << answer.err;
  const Answer judge = answer_to({"judge", file_.c_str()});
  EXPECT_TRUE(says(judge.err, "this file is of kind tune, not a judge; play it with: autoref run"))
      << judge.err;
}

TEST_F(TuningRun, WaitsForOtherShardsByDefault) {
  EXPECT_TRUE(says(answer_to({"run", "--help"}).out, "600 for kind tune, otherwise 0."));
}

TEST_F(TuningRun, IsReportedWithItsPath) {
  tune();
  const Answer answer = answer_to({"report", results_.c_str()});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(says(content_of(folder_ / "results/report.md"), "autoref run effective.yaml"));
  EXPECT_TRUE(says(content_of(folder_ / "results/plots/tuning_path.csv"), "1,pass_risk,2,"));
}

TEST_F(TuningRun, IsSubmittedAsOneTaskUnlessToldOtherwise) {
  const Answer answer = answer_to(
      {"experiment", "submit", file_.c_str(), "--slurm", "-o", results_.c_str(), "--dry-run"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  const std::string script = content_of(folder_ / "results/submit.sbatch");
  EXPECT_TRUE(says(script, "--array=0-0")) << script;
  EXPECT_TRUE(says(script, " run '")) << script;
  const Answer many = answer_to({"experiment", "submit", file_.c_str(), "--slurm", "-o",
                                 results_.c_str(), "--dry-run", "--tasks", "3"});
  EXPECT_EQ(many.code, io::kBadInput);  // an iteration has two pairs of legs
}

}  // namespace
}  // namespace autoref::app
