// Tests `autoref run` with games of a few seconds: the effects of its options, and its messages
// about a folder that already contains games.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/csv.hpp"
#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class RunVerb : public testing::Test {
 protected:
  void SetUp() override { write_file("seed: 1\npairs: 1\n"); }
  void write_file(const std::string& further) {
    write_content(file_,
                  "schema: 1\nkind: sweep\n"
                  "base:\n  teams: { a: { strategy: dummy }, b: { strategy: dummy } }\n"
                  "  match: { rules: paper, half_s: 1 }\n"
                  "factors: { b.robots: [6, 5] }\n" +
                      further);
  }
  Answer run(std::vector<const char*> further = {}) const {
    std::vector<const char*> words = {"run", file_.c_str(), "-o", results_.c_str(), "-j", "1"};
    words.insert(words.end(), further.begin(), further.end());
    return answer_to(words);
  }
  std::string effective() const { return content_of(folder_ / "results/effective.yaml"); }

  TemporaryFolder folder_;
  std::string file_ = (folder_ / "short.yaml").string();
  std::string results_ = (folder_ / "results").string();
};

TEST_F(RunVerb, PlaysTheGivenNumberOfPairsFromTheGivenSeed) {
  const Answer answer = run({"--pairs", "2", "--seed", "7"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(holds(effective(), "pairs: 2\nseed: 7\n")) << effective();
  write_file("seed: 7\npairs: 2\n");
  const Answer same = run();  // nothing is left to play
  EXPECT_TRUE(holds(same.err, "8/8 games   0 void")) << same.err;
}

TEST_F(RunVerb, RefusesInvalidPairsAndSeeds) {
  for (const char* pairs : {"0", "x", "10000", "1.5"}) {
    const Answer answer = run({"--pairs", pairs});
    EXPECT_EQ(answer.code, io::kBadInput);
    EXPECT_TRUE(holds(answer.err, "--pairs: expected a whole number from 1 to 9999")) << answer.err;
  }
  EXPECT_TRUE(holds(run({"--seed", "x"}).err, "--seed: expected a whole number"));
}

TEST_F(RunVerb, RefusesPairsOfAKnockout) {
  const std::string knockout = in_checkout("scenarios/knockout.yaml");
  const Answer answer =
      answer_to({"run", knockout.c_str(), "-o", results_.c_str(), "--pairs", "2"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_TRUE(holds(answer.err, "--pairs: a knockout has no pairs")) << answer.err;
}

TEST_F(RunVerb, UsesPairsAsTheMaximumOfAnSprt) {
  const std::string sprt = in_checkout("scenarios/sprt.yaml");
  const Answer games = answer_to({"check", sprt.c_str(), "--games", "--pairs", "11"});
  EXPECT_EQ(std::count(games.out.begin(), games.out.end(), '\n'), 22);
  const Answer few = answer_to({"check", sprt.c_str(), "--pairs", "3"});
  EXPECT_EQ(few.code, io::kBadInput);
  EXPECT_TRUE(holds(few.err, "--pairs: sprt.max_pairs: must be at least min_pairs")) << few.err;
}

TEST_F(RunVerb, HasPairsAndSeedInCommonWithCheckAndSubmit) {
  const Answer games = answer_to({"check", file_.c_str(), "--games", "--pairs", "3"});
  EXPECT_EQ(std::count(games.out.begin(), games.out.end(), '\n'), 12);
  const Answer submitted = answer_to({"experiment", "submit", file_.c_str(), "-o", results_.c_str(),
                                      "--slurm", "--dry-run", "--pairs", "3", "--seed", "7"});
  EXPECT_EQ(submitted.code, io::kDone) << submitted.err;
  EXPECT_TRUE(holds(submitted.out, "12 games in 6 tasks")) << submitted.out;
  const std::string script = content_of(folder_ / "results/submit.sbatch");
  EXPECT_TRUE(holds(script, " -j 1 '--pairs=3' '--seed=7' &\n")) << script;
}

TEST_F(RunVerb, PrintsNothingWhenQuiet) {
  const Answer answer = run({"--quiet"});
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_EQ(answer.out + answer.err, "");
  EXPECT_TRUE(fs::exists(folder_ / "results/summary.csv"));
}

TEST_F(RunVerb, PrintsErrorsEvenWhenQuiet) {
  run();
  EXPECT_NE(run({"--quiet", "--seed", "2"}).err, "");
}

TEST_F(RunVerb, WritesNoProgressIfDisabled) {
  const Answer answer = run({"--progress", "none"});
  EXPECT_EQ(answer.err, "");
  EXPECT_TRUE(holds(answer.out, "b.robots"));
}

TEST_F(RunVerb, WritesProgressAsJsonLines) {
  const std::string err = run({"--progress", "json"}).err;
  const std::vector<std::string_view> lines = io::complete_lines(err);
  ASSERT_FALSE(lines.empty());
  for (const std::string_view line : lines) EXPECT_TRUE(line.starts_with("{\"event\": ")) << line;
  const std::string last(lines.back());
  EXPECT_TRUE(holds(last,
                    "{\"event\": \"end\", \"done\": 4, \"total\": 4, \"void\": 0, "
                    "\"played\": 4, \"elapsed_s\": "))
      << last;
  EXPECT_TRUE(holds(last, "\"groups\": [{\"values\": [\"6\"], \"games\": 2, ")) << last;
}

TEST_F(RunVerb, WritesNotesAsJsonToo) {
  run();
  const Answer answer = run({"--progress", "json", "--pairs", "2"});
  EXPECT_TRUE(answer.err.starts_with("{\"event\": \"note\", \"text\": \"the folder had 1 pairs"))
      << answer.err;
}

TEST_F(RunVerb, ReportsThatMorePairsContinueTheFolder) {
  run();
  const Answer answer = run({"--pairs", "3"});
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_TRUE(
      answer.err.starts_with("the folder had 1 pairs, now 3; the games already played count, and "
                             "only the others are played\n"))
      << answer.err;
}

TEST_F(RunVerb, ReportsTheRowsThatFewerPairsLeaveOut) {
  run({"--pairs", "3"});
  const Answer answer = run();
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_TRUE(answer.err.starts_with("the folder had 3 pairs, now 1: 8 surplus rows do not count"))
      << answer.err;
  EXPECT_TRUE(holds(answer.err, "count again with --pairs 3")) << answer.err;
  const Answer status = answer_to({"results", "status", results_.c_str()});
  EXPECT_TRUE(holds(status.out, "4 of 4 games done")) << status.out;
  EXPECT_TRUE(holds(status.out, "8 rows do not belong to any game of the experiment"))
      << status.out;
}

TEST_F(RunVerb, RefusesAnotherSeedAndSuggestsAnotherFolder) {
  run();
  const std::string rows = content_of(folder_ / "results/games/shard-0-of-1.csv");
  const auto is_refused = [&](const Answer& answer) {
    EXPECT_EQ(answer.code, io::kBadInput);
    EXPECT_TRUE(
        holds(answer.err, "holds games of seed 1, but this is seed 5; continue with --seed 1"))
        << answer.err;
    EXPECT_TRUE(holds(answer.err, fmt::format("-o {}-seed-5", results_))) << answer.err;
    EXPECT_EQ(content_of(folder_ / "results/games/shard-0-of-1.csv"), rows);
  };
  is_refused(run({"--seed", "5"}));
  is_refused(run({"--seed", "5", "--pairs", "4"}));
  write_file("seed: 5\npairs: 1\n");
  is_refused(run());
  EXPECT_EQ(run({"--seed", "1"}).code, io::kDone);
}

TEST_F(RunVerb, UpdatesAStaleReport) {
  run();
  EXPECT_FALSE(fs::exists(folder_ / "results/report.html"));  // no report was requested
  answer_to({"report", results_.c_str()});
  const Answer answer = run({"--pairs", "2"});
  EXPECT_TRUE(holds(answer.out, "report.html   updated")) << answer.out;
  EXPECT_TRUE(holds(content_of(folder_ / "results/report.md"), "| games | 8 of 8 |"));
  EXPECT_TRUE(holds(content_of(folder_ / "results/report.html"), "8 of 8"));
  EXPECT_FALSE(holds(run({"--pairs", "2"}).out, "updated"));
  EXPECT_FALSE(holds(answer_to({"results", "status", results_.c_str()}).out, "report.html"));
}

TEST_F(RunVerb, ReportsTheGamesMissingFromAReport) {
  run();
  answer_to({"report", results_.c_str()});
  const Answer shard = run({"--pairs", "3", "--shard", "1/2"});
  EXPECT_TRUE(holds(shard.out,
                    "report.html lacks 4 of the 8 games; update it with: autoref "
                    "report"))
      << shard.out << shard.err;
  const Answer status = answer_to({"results", "status", results_.c_str()});
  EXPECT_TRUE(holds(status.out, "report.html lacks 4 of the 8 games")) << status.out;
}

}  // namespace
}  // namespace autoref::app
