// `log info` and `log export` of several logs.
#include <gtest/gtest.h>

#include <filesystem>

#include "io/csv.hpp"
#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/short_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

class ManyLogs : public testing::Test {
 protected:
  void SetUp() override {
    const std::string log = write_short_log(folder_, "2026-b");
    fs::create_directory(logs_);
    fs::copy(log, logs_ + "/b.log.gz");
    fs::copy(log, logs_ + "/a.log.gz");
  }
  Answer info(std::vector<const char*> more = {}) {
    more.insert(more.begin(), logs_.c_str());
    return answer_to("log info", more);
  }
  Answer export_logs(std::vector<const char*> more = {}) {
    more.insert(more.begin(), {logs_.c_str(), "-o", tables_.c_str()});
    return answer_to("log export", more);
  }
  std::vector<io::Cells> table(const std::string& name) {
    const std::string text = content_of(tables_ + "/" + name);
    std::vector<io::Cells> rows;
    for (const std::string_view line : io::complete_lines(text))
      rows.push_back(io::csv_cells(line).value());
    return rows;
  }

  TemporaryFolder folder_;
  std::string logs_ = folder_ / "logs";
  std::string tables_ = folder_ / "tables";
};

TEST_F(ManyLogs, HaveARowPerLogAndTeamSortedByName) {
  const Answer answer = info();
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  const std::size_t a = answer.out.find("a.log.gz   yellow");
  const std::size_t b = answer.out.find("b.log.gz   yellow");
  EXPECT_NE(a, std::string::npos) << answer.out;
  EXPECT_LT(a, b) << answer.out;
  EXPECT_NE(answer.out.find("b.log.gz   blue", b), std::string::npos) << answer.out;
}

TEST_F(ManyLogs, AreAListInJson) {
  const Answer answer = info({"--json"});
  EXPECT_TRUE(answer.out.starts_with(R"([{"log": )")) << answer.out;
  EXPECT_NE(answer.out.find(R"("robots_p99_mps": )"), std::string::npos) << answer.out;
}

TEST_F(ManyLogs, AreSummarisedEvenIfOthersAreNotLogs) {
  write_content(logs_ + "/0.log", "no log");
  const Answer answer = info();
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("0.log"), std::string::npos) << answer.err;
  EXPECT_NE(answer.out.find("b.log.gz   blue"), std::string::npos) << answer.out;
}

TEST_F(ManyLogs, CannotListTheirCommands) {
  const Answer answer = info({"--commands"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_TRUE(answer.err.starts_with("autoref: --commands: ")) << answer.err;
}

TEST_F(ManyLogs, AreMissingInAnEmptyFolder) {
  const std::string empty = folder_ / "empty";
  fs::create_directory(empty);
  const Answer answer = answer_to({"log", "info", empty.c_str()});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("contains no .log or .log.gz file"), std::string::npos) << answer.err;
}

TEST_F(ManyLogs, BecomeTablesWithARowPerObjectAndFrame) {
  const Answer answer = export_logs();
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  const std::vector<io::Cells> tracks = table("tracks.csv");
  ASSERT_GT(tracks.size(), 26U);
  EXPECT_EQ(tracks[1][2], "ball");
  EXPECT_EQ(tracks[1][3], "");
  EXPECT_EQ(tracks[2][2], "yellow");
  EXPECT_EQ(tracks[2][1], tracks[1][1]);
  EXPECT_LT(std::abs(std::stod(tracks[1][4])), 0.01);  // the ball is at the centre
  EXPECT_EQ(tracks.front().size(), tracks.back().size());
  EXPECT_TRUE(tracks.back()[0].ends_with("b.log.gz"));
  EXPECT_FALSE(table("chains.csv").empty());
  EXPECT_FALSE(table("actions.csv").empty());
  EXPECT_FALSE(table("shots.csv").empty());
}

TEST_F(ManyLogs, ReplaceTablesOnlyWithForce) {
  EXPECT_EQ(export_logs({"--what", "chains,shots"}).code, io::kDone);
  EXPECT_FALSE(fs::exists(tables_ + "/tracks.csv"));
  const Answer answer = export_logs({"--what", "shots"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("--force"), std::string::npos) << answer.err;
  EXPECT_EQ(export_logs({"--what", "shots", "--force"}).code, io::kDone);
}

}  // namespace
}  // namespace autoref::app
