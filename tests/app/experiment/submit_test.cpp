// Tests `autoref experiment submit` with a fake sbatch, which records the arguments that Slurm
// would get. tests/slurm/ uses a real sbatch.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "experiments/run/slurm.hpp"
#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

// Replaces PATH during its lifetime.
class PathTo {
 public:
  explicit PathTo(const fs::path& path) : former_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~PathTo() { setenv("PATH", former_.c_str(), 1); }
  PathTo(const PathTo&) = delete;
  PathTo& operator=(const PathTo&) = delete;

 private:
  std::string former_;
};

class Submit : public testing::Test {
 protected:
  void SetUp() override {
    write_content(file_,
                  "schema: 1\nkind: sweep\nseed: 1\npairs: 5\nfactors: { b.robots: [6, 5] }\n");
  }

  // Installs an sbatch that writes its arguments to "said", one per line, and prints a job number.
  void put_sbatch(const std::string& answer) {
    const fs::path sbatch = folder_ / "sbatch";
    write_content(sbatch, fmt::format("#!/bin/sh\nprintf '%s\\n' \"$@\" >>'{}'\n{}\n",
                                      (folder_ / "said").string(), answer));
    fs::permissions(sbatch, fs::perms::owner_all);
  }

  Answer submit(std::vector<const char*> further) {
    const PathTo path(folder_.path());
    std::vector<const char*> words = {"experiment", "submit", file_.c_str(),
                                      "--slurm",    "-o",     results_.c_str()};
    words.insert(words.end(), further.begin(), further.end());
    return answer_to(words);
  }

  std::string script() const { return content_of(folder_ / "my results/submit.sbatch"); }

  TemporaryFolder folder_;
  std::string file_ = (folder_ / "it's.yaml").string();
  std::string results_ = (folder_ / "my results").string();
};

TEST_F(Submit, SubmitsTheArrayAndAMergeJobAfterIt) {
  put_sbatch("echo '42;somewhere'");
  const Answer answer = submit({});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_EQ(content_of(folder_ / "said"),
            fmt::format("--parsable\n{0}/submit.sbatch\n--parsable\n--dependency=afterany:42\n"
                        "{0}/merge.sbatch\n",
                        results_));
  EXPECT_NE(answer.out.find("submitted as job 42\n"), std::string::npos) << answer.out;
}

TEST_F(Submit, OnlyWritesTheScriptsInADryRun) {
  const Answer answer = submit({"--dry-run"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(fs::exists(folder_ / "my results/merge.sbatch"));
  EXPECT_NE(answer.out.find("nothing was submitted"), std::string::npos) << answer.out;
}

TEST_F(Submit, QuotesPaths) {
  submit({"--dry-run", "--tasks", "3", "-j", "2"});
  const std::string run =
      fmt::format(" run {} -o {} --shard \"$SLURM_ARRAY_TASK_ID/3\" -j 2 &\n",
                  experiments::shell_word(file_), experiments::shell_word(results_));
  EXPECT_NE(script().find(run), std::string::npos) << script();
  EXPECT_NE(script().find(fmt::format("#SBATCH '--output={}/slurm/%A_%a.log'\n", results_)),
            std::string::npos);
}

TEST_F(Submit, PassesOnLimitsAndOtherOptions) {
  submit({"--dry-run", "--tasks", "3", "-j", "2", "--time", "01:30:00", "--partition", "long",
          "--sbatch=--account=vision", "--sbatch=--mem=1G"});
  for (const char* line : {"--array=0-2", "--cpus-per-task=2", "--time=01:30:00", "--requeue",
                           "'--partition=long'", "'--account=vision'", "'--mem=1G'"}) {
    EXPECT_NE(script().find(fmt::format("#SBATCH {}\n", line)), std::string::npos) << line;
  }
}

TEST_F(Submit, DoesNotSplitPairsOfLegs) {
  EXPECT_EQ(submit({"--dry-run", "--tasks", "10"}).code, io::kDone);
  const Answer answer = submit({"--dry-run", "--tasks", "11"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("--tasks: 20 games are 10 pairs of legs"), std::string::npos)
      << answer.err;
}

TEST_F(Submit, RefusesAnInvalidTime) {
  for (const char* time : {"90", "01:30", "1:2:3:4", "00:04:59", "01:60:00", "x", "-1:00:00"}) {
    const Answer answer = submit({"--dry-run", "--time", time});
    EXPECT_EQ(answer.code, io::kBadInput) << time;
    EXPECT_NE(answer.err.find("--time"), std::string::npos) << answer.err;
  }
}

TEST_F(Submit, SaysWhatToDoWithoutSlurm) {
  const Answer answer = submit({});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("sbatch is not in PATH"), std::string::npos) << answer.err;
  EXPECT_NE(answer.err.find("--dry-run"), std::string::npos) << answer.err;
}

TEST_F(Submit, ReportsThatSlurmRejectsAJob) {
  put_sbatch("exit 1");
  const Answer answer = submit({});
  EXPECT_EQ(answer.code, io::kInputOutput);
  EXPECT_NE(answer.err.find("submit.sbatch with code 1"), std::string::npos) << answer.err;
}

TEST(ShellWord, KeepsEveryCharacter) {
  EXPECT_EQ(experiments::shell_word("it's $x"), "'it'\\''s $x'");
}

}  // namespace
}  // namespace autoref::app
