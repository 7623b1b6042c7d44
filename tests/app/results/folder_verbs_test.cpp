// Tests the verbs that read a results folder, with games of a few seconds.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/time_limit.hpp"

namespace autoref::app {
namespace {

class FolderVerbs : public testing::Test {
 protected:
  void SetUp() override {
    write_content(folder_ / "short.yaml",
                  "schema: 1\nkind: sweep\nseed: 1\npairs: 1\n"
                  "base:\n  teams: { a: { strategy: dummy }, b: { strategy: dummy } }\n"
                  "  match: { rules: paper, half_s: 5 }\n"
                  "factors: { b.robots: [6, 5] }\n");
  }
  Answer run(const char* shard) const {
    return answer_to({"run", file_.c_str(), "-o", results_.c_str(), "-j", "1", "--shard", shard});
  }

  TemporaryFolder folder_;
  std::string file_ = (folder_ / "short.yaml").string();
  std::string results_ = (folder_ / "results").string();
};

TEST_F(FolderVerbs, CheckListsAndTriesTheGames) {
  const Answer games = answer_to({"check", file_.c_str(), "--games"});
  EXPECT_EQ(games.code, io::kDone);
  EXPECT_TRUE(games.out.starts_with("b.robots=6-p0001-1\nb.robots=6-p0001-2\n")) << games.out;
  const Answer checked = answer_to({"check", file_.c_str(), "-j", "1"});
  EXPECT_EQ(checked.code, io::kDone);
  EXPECT_NE(checked.out.find("b.robots=5       2"), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("\n4 games, about "), std::string::npos) << checked.out;
}

TEST_F(FolderVerbs, CheckNamesTheCostOfPrograms) {
  const std::string file = (folder_ / "python.yaml").string();
  write_content(file,
                "schema: 1\nkind: roundrobin\nseed: 1\npairs: 1\n"
                "base: { match: { rules: paper, half_s: 5 } }\n"
                "teams:\n  still: { strategy: dummy }\n  mine: { command: [python3, " +
                    in_checkout("game/team_programs/templates/python/my_team.py") + "] }\n");
  const Answer checked = answer_to({"check", file.c_str()});
  EXPECT_EQ(checked.code, io::kDone) << checked.err;
  EXPECT_NE(checked.out.find("of that, the teams' programs take: mine "), std::string::npos)
      << checked.out;
}

// Whole games of all 28 matchups take longer than a check.
TEST_F(FolderVerbs, CheckTriesEveryMatchupOfALongExperiment) {
  const std::string robin = in_checkout("scenarios/roundrobin.yaml");
  const Answer checked =
      answer_to({"check", robin.c_str(), "-j", "1", "--set", "match.half_s=3000"});
  EXPECT_EQ(checked.out.find("not tried"), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("% of a game\n"), std::string::npos) << checked.out;
}

TEST_F(FolderVerbs, StatusShowsProgress) {
  EXPECT_NE(run("0/2").out.find("shard 0/2 is done: 2 of 4 games"), std::string::npos);
  const std::string half = answer_to({"results", "status", results_.c_str()}).out;
  EXPECT_NE(half.find("2 of 4 games done, 0 void"), std::string::npos) << half;
  EXPECT_NE(half.find("because of interim intervals"), std::string::npos);
  run("1/2");
  const std::string whole = answer_to({"results", "status", results_.c_str()}).out;
  EXPECT_NE(whole.find("4 of 4 games done, 0 void\n  shard 0/2   2 games\n"), std::string::npos);
  EXPECT_EQ(whole.find("interim"), std::string::npos);
}

TEST_F(FolderVerbs, SayWhatIsThereIfTheScenarioIsMissing) {
  run("0/2");
  run("1/2");
  std::filesystem::remove(folder_ / "results/effective.yaml");
  for (const char* verb : {"results status", "report"}) {
    const Answer answer = answer_to(verb, {results_.c_str()});
    EXPECT_EQ(answer.code, io::kBadInput);
    EXPECT_NE(answer.err.find("games/ has 4 rows in 2 files, but effective.yaml, which says what "
                              "experiment they belong to, is missing. Copy it from"),
              std::string::npos)
        << answer.err;
  }
  EXPECT_EQ(run("0/2").code, io::kDone);
  EXPECT_NE(answer_to({"results", "status", results_.c_str()}).out.find("4 of 4 games done"),
            std::string::npos)
      << "the message advises this";
}

TEST_F(FolderVerbs, SayWhichFolderIsMeant) {
  run("0/1");
  const std::string games = folder_ / "results/games";
  EXPECT_NE(answer_to({"results", "status", games.c_str()}).err.find("; give that folder instead"),
            std::string::npos);
  const std::string above = folder_.path().string();
  EXPECT_NE(
      answer_to({"results", "status", above.c_str()}).err.find("give one of them: " + results_),
      std::string::npos);
  const std::string nowhere = folder_ / "nowhere";
  EXPECT_NE(answer_to({"results", "status", nowhere.c_str()})
                .err.find("holds no results: it does not exist"),
            std::string::npos);
}

TEST_F(FolderVerbs, ReportMergesTheRowsOfShards) {
  run("0/2");
  run("1/2");
  const std::string merged = content_of(folder_ / "results/results.csv");
  std::filesystem::remove(folder_ / "results/results.csv");
  EXPECT_EQ(answer_to({"report", results_.c_str()}).code, io::kDone);
  EXPECT_EQ(content_of(folder_ / "results/results.csv"), merged);
}

TEST_F(FolderVerbs, ReportWritesFiles) {
  run("0/1");
  const Answer answer = answer_to({"report", results_.c_str()});
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_NE(answer.out.find("report.html   the same report as a single page for a browser"),
            std::string::npos);
  EXPECT_TRUE(content_of(folder_ / "results/report.md").starts_with("# A sweep\n"));
}

TEST_F(FolderVerbs, VerifyAndReplayPlayGamesAgain) {
  run("0/1");
  const Answer verified =
      answer_to({"results", "verify", results_.c_str(), "--sample", "3", "-j", "1"});
  EXPECT_EQ(verified.code, io::kDone);
  EXPECT_NE(verified.out.find("3 of 3 games match their rows"), std::string::npos);
  const Answer replayed = answer_to({"results", "replay", results_.c_str(), "b.robots=5-p0001-2"});
  EXPECT_EQ(replayed.code, io::kDone);
  EXPECT_NE(replayed.out.find("dummy, east"), std::string::npos) << replayed.out;
}

// With four games, whose rows are changed by hand.
class ChangedFolder : public FolderVerbs {
 protected:
  void SetUp() override {
    FolderVerbs::SetUp();
    run("0/1");
    rows_ = content_of(shard_);
    results_csv_ = content_of(folder_ / "results/results.csv");
  }
  void change_a_score() const {
    std::string rows = rows_;
    const std::size_t line = rows.find("\nb.robots=5-p0001-1,");
    const std::size_t score = rows.find(",0,0,0,", line);
    rows.at(score + 1) = '9';
    write_content(shard_, rows);
  }
  void remove_last_row() const {
    write_content(shard_, rows_.substr(0, rows_.rfind('\n', rows_.size() - 2) + 1));
  }
  Answer report() const { return answer_to({"report", results_.c_str()}); }

  std::string shard_ = (folder_ / "results/games/shard-0-of-1.csv").string();
  std::string rows_;
  std::string results_csv_;
};

constexpr const char* kDamagedRow = "the row of b.robots=5-p0001-1 is damaged and does not count";

TEST_F(ChangedFolder, IsNoticedByVerify) {
  change_a_score();
  const Answer verified =
      answer_to({"results", "verify", results_.c_str(), "--sample", "9", "-j", "1"});
  EXPECT_EQ(verified.code, io::kDifferent);
  EXPECT_NE(verified.out.find(kDamagedRow), std::string::npos) << verified.out;
}

TEST_F(ChangedFolder, IsNoticedByReportWhichKeepsTheResults) {
  change_a_score();
  const Answer reported = report();
  EXPECT_EQ(reported.code, io::kDifferent);
  EXPECT_NE(reported.err.find(kDamagedRow), std::string::npos) << reported.err;
  EXPECT_EQ(content_of(folder_ / "results/results.csv"), results_csv_);
}

TEST_F(ChangedFolder, IsMendedByTheNextRunOnce) {
  change_a_score();
  EXPECT_NE(run("0/1").err.find("damaged rows that do not count: 1"), std::string::npos);
  EXPECT_EQ(run("0/1").err.find("damaged"), std::string::npos);
  EXPECT_EQ(report().code, io::kDone);
  EXPECT_EQ(content_of(folder_ / "results/results.csv"), results_csv_);
}

TEST_F(ChangedFolder, KeepsItsResultsIfARowIsGone) {
  remove_last_row();
  const Answer reported = report();
  EXPECT_EQ(reported.code, io::kDifferent);
  EXPECT_NE(reported.err.find("in results.csv, but without a row in games/: b.robots="),
            std::string::npos)
      << reported.err;
  EXPECT_EQ(content_of(folder_ / "results/results.csv"), results_csv_);
}

TEST_F(ChangedFolder, LosesResultsOnlyOnRequest) {
  remove_last_row();
  EXPECT_EQ(answer_to({"report", results_.c_str(), "--allow-fewer"}).code, io::kDifferent);
  EXPECT_LT(content_of(folder_ / "results/results.csv").size(), results_csv_.size());
  EXPECT_EQ(report().code, io::kDone);
}

TEST_F(FolderVerbs, DoNotWaitForAPipeInPlaceOfAResult) {
  const TimeLimit limit;
  run("0/1");
  answer_to({"report", results_.c_str()});
  for (const std::string name :
       {"effective.yaml", "results.csv", "summary.csv", "report.md", "games/shard-0-of-1.csv"}) {
    const std::filesystem::path pipe = folder_ / ("results/" + name);
    std::filesystem::rename(pipe, folder_ / "kept");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const Answer& answer : {run("0/1"), answer_to({"report", results_.c_str()}),
                                 answer_to({"results", "status", results_.c_str()}),
                                 answer_to({"results", "verify", results_.c_str(), "-j", "1"})}) {
      if (answer.code == io::kDone) continue;  // does not need this file
      EXPECT_TRUE(answer.code == io::kInputOutput || answer.code == io::kBadInput) << answer.code;
      EXPECT_NE((answer.out + answer.err).find(pipe.string()), std::string::npos) << answer.err;
    }
    EXPECT_NE(answer_to({"report", results_.c_str()}).code, io::kDone) << name;
    std::filesystem::rename(folder_ / "kept", pipe);
  }
}

TEST_F(FolderVerbs, ReplaySuggestsTheClosestGame) {
  run("0/1");
  const Answer answer = answer_to({"results", "replay", results_.c_str(), "b.robots=5-p001-2"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("did you mean 'b.robots=5-p0001-2'"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace autoref::app
