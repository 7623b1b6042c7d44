// Judged games are saved as they end: each game is judged once and can be looked up by its id.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <set>
#include <thread>

#include "io/csv.hpp"
#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::judge {
namespace {

class JudgedRun : public testing::Test {
 protected:
  void SetUp() override { write_file(""); }

  // Four games with two cameras; `more` is additional YAML.
  void write_file(const std::string& more, const char* seed = "3") const {
    write_content(file_, std::string("schema: 1\nkind: judge\nbase: { match: { half_s: 40 } }\n"
                                     "cameras: [none, realistic]\nmatchups: [rowdy~basic]\n"
                                     "games: 2\nseed: ") +
                             seed + "\n" + more);
  }

  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  app::Answer judge(const std::string& results, const char* workers = "2") const {
    return app::answer_to({"judge", file_.c_str(), "-o", results.c_str(), "-j", workers});
  }
  static app::Answer ask(const char* verb, const std::string& results,
                         const std::vector<const char*>& more = {}) {
    std::vector<const char*> arguments = {results.c_str()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return app::answer_to(verb, arguments);
  }
  static std::string rows_file(const std::string& results) {
    return results + "/games/shard-0-of-1.csv";
  }
  // Truncates the file to the head, `rows` rows and half of the next row.
  static void tear(const std::string& results, int rows) {
    const std::string text = content_of(rows_file(results));
    std::size_t end = 0;
    for (int line = 0; line <= rows; ++line) end = text.find('\n', end) + 1;
    write_content(rows_file(results), text.substr(0, end + 100));
    std::filesystem::remove(results + "/judge.csv");
    std::filesystem::remove(results + "/faults.csv");
  }
  static std::vector<std::string> fault_ids(const std::string& results) {
    const std::string text = content_of(results + "/faults.csv");
    std::vector<std::string> ids;
    for (const std::string_view line : io::complete_lines(text)) {
      ids.push_back(io::csv_cells(line)->back());
    }
    return ids;
  }
  static std::ptrdiff_t rows_in(const std::string& results) {
    const std::string text = content_of(rows_file(results));
    return std::count(text.begin(), text.end(), '\n') - 1;
  }
  // Judges in a process that gets Ctrl-C after its first game. Returns the process's status.
  int judge_and_interrupt(const std::string& results) const {
    const pid_t child = fork();
    if (child == 0) {
      std::freopen("/dev/null", "w", stdout);
      std::freopen("/dev/null", "w", stderr);
      const std::vector<const char*> arguments = {
          "autoref", "judge", file_.c_str(), "-o", results.c_str(), "-j", "1"};
      _exit(app::run_command_line(static_cast<int>(arguments.size()), arguments.data()));
    }
    for (int i = 0; i < 30000 && rows_in(results) < 1; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }
  static void expect_same_results(const std::string& one, const std::string& other) {
    for (const char* name : {"/judge.csv", "/faults.csv", "/effective.yaml"})
      EXPECT_EQ(content_of(one + name), content_of(other + name)) << name;
  }

  TemporaryFolder folder_;
  std::string file_ = in("judge.yaml");
  std::string whole_ = in("whole");
};

TEST_F(JudgedRun, HasTheSameResultWithAnyNumberOfWorkers) {
  const app::Answer one = judge(whole_, "1");
  EXPECT_EQ(one.code, io::kDone) << one.err;
  const app::Answer three = judge(in("three"), "3");
  expect_same_results(whole_, in("three"));
  EXPECT_EQ(one.out.substr(0, one.out.find(whole_)), three.out.substr(0, three.out.find(in(""))));
}

TEST_F(JudgedRun, ContinuesWhereItStopped) {
  const app::Answer whole = judge(whole_);
  const std::string torn = in("torn");
  judge(torn);
  tear(torn, 1);
  const app::Answer again = judge(torn, "1");
  EXPECT_EQ(again.code, io::kDone) << again.err;
  EXPECT_NE(again.err.find("4/4 games"), std::string::npos) << again.err;
  expect_same_results(whole_, torn);
}

TEST_F(JudgedRun, ReportsCtrlCAndContinuesWithTheSameCommand) {
  judge(whole_);
  std::string ended;
  int status = 0;
  // On a busy machine, Ctrl-C may come after the last game.
  for (int attempt = 0; attempt < 20 && (attempt == 0 || rows_in(ended) == 4); ++attempt) {
    ended = in("ended-" + std::to_string(attempt));
    status = judge_and_interrupt(ended);
  }
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), io::kInterrupted);
  EXPECT_LT(rows_in(ended), 4);
  EXPECT_FALSE(std::filesystem::exists(ended + "/judge.csv"));
  EXPECT_EQ(judge(ended).code, io::kDone);
  expect_same_results(whole_, ended);
}

TEST_F(JudgedRun, JudgesAGameAgainIfItsRowIsDamaged) {
  judge(whole_);
  const std::string damaged = in("damaged");
  judge(damaged);
  std::string text = content_of(rows_file(damaged));
  text[text.find(",none,") + 1] = 'm';
  write_content(rows_file(damaged), text);
  const app::Answer again = judge(damaged);
  EXPECT_NE(again.err.find("damaged rows that do not count: 1"), std::string::npos) << again.err;
  expect_same_results(whole_, damaged);
}

TEST_F(JudgedRun, RefusesTheRowsOfAnotherSeed) {
  judge(whole_);
  write_file("", "4");
  const app::Answer other = judge(whole_);
  EXPECT_EQ(other.code, io::kBadInput);
  EXPECT_NE(other.err.find("holds games of seed 3, but this is seed 4"), std::string::npos)
      << other.err;
}

TEST_F(JudgedRun, PlaysTheGamesOfOneNamedSeedAndThenTheOthers) {
  write_content(file_,
                "schema: 1\nkind: judge\nbase: { match: { half_s: 20 } }\n"
                "cameras: [none]\nteams: [rowdy, basic]\ngames: 2\n"
                "seeds: { tuning: 3, test: 1c9f03ae }\n");
  const app::Answer one =
      app::answer_to({"judge", file_.c_str(), "-o", whole_.c_str(), "--seeds", "test"});
  EXPECT_EQ(one.code, io::kDone) << one.err;
  EXPECT_TRUE(one.out.starts_with("seeds: test 1c9f03ae (480183214)\n")) << one.out;
  const std::string tests = content_of(rows_file(whole_));
  const app::Answer both = judge(whole_);
  EXPECT_EQ(both.code, io::kDone) << both.err;
  EXPECT_TRUE(both.out.starts_with("seeds: tuning 3, test 1c9f03ae (480183214)\n")) << both.out;
  EXPECT_TRUE(content_of(rows_file(whole_)).starts_with(tests));
  EXPECT_NE(content_of(whole_ + "/judge.csv").find("\ntuning,paper,none,"), std::string::npos);
}

TEST_F(JudgedRun, RefusesAnUnknownSeed) {
  const app::Answer answer =
      app::answer_to({"judge", file_.c_str(), "-o", whole_.c_str(), "--seeds", "test"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("--seeds: the file has a single `seed`"), std::string::npos)
      << answer.err;
}

TEST_F(JudgedRun, ShowsItsProgress) {
  judge(whole_);
  EXPECT_TRUE(
      ask("results status", whole_).out.starts_with(whole_ + "   4 of 4 games done, 0 void\n"));
  tear(whole_, 2);
  const app::Answer half = ask("results status", whole_);
  EXPECT_EQ(half.code, io::kDone) << half.err;
  EXPECT_TRUE(half.out.starts_with(whole_ + "   2 of 4 games done, 0 void\n")) << half.out;
  EXPECT_NE(half.out.find("| F1 of | rules | none | realistic |"), std::string::npos) << half.out;
}

TEST_F(JudgedRun, IsReportedAsAPage) {
  const app::Answer judged = judge(whole_);
  const std::string csv = content_of(whole_ + "/judge.csv");
  std::filesystem::remove(whole_ + "/judge.csv");
  const app::Answer answer = ask("report", whole_);
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_EQ(content_of(whole_ + "/judge.csv"), csv);
  EXPECT_TRUE(answer.out.starts_with(judged.out.substr(0, judged.out.find(whole_))));
  const std::string markdown = content_of(whole_ + "/report.md");
  EXPECT_NE(markdown.find("## F1 by rule book"), std::string::npos);
  EXPECT_NE(markdown.find("| games | 4 of 4 |"), std::string::npos) << markdown;
  EXPECT_NE(content_of(whole_ + "/report.html").find("throw_in"), std::string::npos);
  EXPECT_EQ(ask("report", whole_).code, io::kDone);
  EXPECT_EQ(content_of(whole_ + "/report.md"), markdown);
}

TEST_F(JudgedRun, GivesEachFaultAnIdThatReplaysItsGame) {
  write_file("rules: [2026-b]\n");
  judge(whole_);
  const std::vector<std::string> ids = fault_ids(whole_);
  ASSERT_GT(ids.size(), 1U);
  EXPECT_EQ(ids.front(), "id");
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
  const std::string& id = ids.back();
  const std::string events = in("events.jsonl");
  const app::Answer answer =
      ask("results replay", whole_, {id.c_str(), "--events", events.c_str()});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_NE(answer.out.find("rowdy"), std::string::npos) << answer.out;
  const bool says_fault = answer.err.starts_with("autoref: " + id + ": missed ") ||
                          answer.err.starts_with("autoref: " + id + ": wrong ");
  EXPECT_TRUE(says_fault) << answer.err;
  EXPECT_NE(content_of(events).find("\"transition\": \"begin\""), std::string::npos);
}

TEST_F(JudgedRun, ReplaysAGameByEitherIdAndRefusesUnknownIds) {
  judge(whole_);
  EXPECT_EQ(ask("results replay", whole_, {"paper none rowdy~basic 2"}).code, io::kDone);
  EXPECT_EQ(ask("results replay", whole_, {"paper+none+rowdy~basic-p0001-2"}).code, io::kDone);
  for (const char* id : {"paper+none+rowdy~basic-p0001-3", "paper+none+rowdy~basic-p0001-2-f999",
                         "paper+none+rowdy~basic-p0001-2-f0"}) {
    const app::Answer answer = ask("results replay", whole_, {id});
    EXPECT_EQ(answer.code, io::kBadInput) << id;
    EXPECT_NE(answer.err.find("did you mean 'paper+none+rowdy~basic-p0001-"), std::string::npos)
        << answer.err;
  }
}

TEST_F(JudgedRun, IsVerifiedByReplayingItsGames) {
  judge(whole_);
  const app::Answer answer = ask("results verify", whole_, {"--sample", "2", "-j", "1"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_NE(answer.out.find("2 of 2 games match their rows"), std::string::npos);
}

}  // namespace
}  // namespace autoref::judge
