// Outputs that would overwrite each other or an input are refused before any work.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "io/errors.hpp"
#include "io/files.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/time_limit.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

class Outputs : public testing::Test {
 protected:
  void SetUp() override {
    write_content(file_,
                  "schema: 1\nkind: game\nteams: { a: { type: fast.yaml } }\n"
                  "match: { half_s: 1 }\n");
    write_content(folder_ / "fast.yaml", "schema: 1\nkind: robot\n");
  }
  std::string in(const std::string& name) const { return (folder_ / name).string(); }

  // Plays with two outputs, or with one if the second flag is empty.
  Answer play(const char* flag, const std::string& path, const char* other = "",
              const std::string& its_path = "") const {
    std::vector<const char*> arguments = {"play", file_.c_str(), flag, path.c_str()};
    if (*other != '\0') arguments.insert(arguments.end(), {other, its_path.c_str()});
    return answer_to(arguments);
  }

  static void expect_refused(const Answer& answer, const std::string& start) {
    EXPECT_EQ(answer.code, io::kBadInput) << start;
    EXPECT_TRUE(answer.err.starts_with("autoref: " + start + ": ")) << answer.err;
    EXPECT_EQ(answer.out, "") << start;  // no game was played
  }

  TemporaryFolder folder_;
  std::string file_ = in("game.yaml");
};

TEST_F(Outputs, MayBelongToAGameThatComesThroughAPipe) {
  const TimeLimit limit;
  const std::string pipe = in("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread user([&] { write_content(pipe, "schema: 1\nkind: game\nmatch: { half_s: 1 }\n"); });
  const Answer answer = answer_to({"play", pipe.c_str(), "--events", "/dev/null"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  user.join();
}

TEST_F(Outputs, ThatAreTheSameFileAreRefusedBeforeTheGame) {
  const std::string x = in("x");
  expect_refused(play("--log", x, "--view", x), "--log and --view");
  expect_refused(play("--events", x, "--log", x), "--events and --log");
  expect_refused(play("--events", x, "--view", x), "--events and --view");
  EXPECT_FALSE(fs::exists(x));
}

TEST_F(Outputs, ThatAreTheSameFileSpeltDifferentlyAreRefused) {
  const std::string x = in("x");
  fs::create_directory(in("sub"));
  for (const char* spelling : {"./x", "sub/../x", "sub/.././x"})
    expect_refused(play("--log", x, "--view", in(spelling)), "--log and --view");
  fs::create_symlink("x", in("link"));  // points to a file that does not exist
  expect_refused(play("--log", x, "--view", in("link")), "--log and --view");
  fs::create_directory_symlink(folder_.path(), in("here"));
  expect_refused(play("--log", x, "--view", in("here/x")), "--log and --view");
  write_content(x, "old");
  fs::create_hard_link(x, in("hard"));
  expect_refused(play("--log", x, "--view", in("hard")), "--log and --view");
  EXPECT_EQ(content_of(x), "old");
}

TEST_F(Outputs, WithATemporaryNameThatIsAnotherOutputAreRefused) {
  expect_refused(play("--log", in("x.part"), "--view", in("x")), "--log and --view");
}

TEST_F(Outputs, ThatAreInputsAreRefused) {
  const std::string scenario = content_of(file_);
  for (const char* flag : {"--events", "--game-events", "--log", "--view"}) {
    expect_refused(play(flag, in("./game.yaml")), flag);
    expect_refused(play(flag, in("fast.yaml")), flag);
  }
  EXPECT_EQ(content_of(file_), scenario);
}

TEST_F(Outputs, ThatAreTheStandardOutputAreRefused) {
  const std::string x = in("x");
  const int file = open(x.c_str(), O_WRONLY | O_CREAT, 0600);
  const int terminal = dup(STDOUT_FILENO);
  dup2(file, STDOUT_FILENO);
  const std::vector<const char*> arguments = {"autoref", "play",   file_.c_str(),
                                              "--json",  "--view", x.c_str()};
  testing::internal::CaptureStderr();
  const int code = run_command_line(static_cast<int>(arguments.size()), arguments.data());
  const std::string error = testing::internal::GetCapturedStderr();
  dup2(terminal, STDOUT_FILENO);
  close(terminal);
  close(file);
  EXPECT_EQ(code, io::kBadInput);
  EXPECT_TRUE(error.starts_with("autoref: --view: standard output also goes to ")) << error;
}

TEST_F(Outputs, ThatAreDifferentFilesAreWritten) {
  const Answer answer = play("--log", in("game.log"), "--view", in("game.html"));
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(content_of(in("game.log")).starts_with("SSL_LOG_FILE"));
  EXPECT_TRUE(content_of(in("game.html")).starts_with("<!"));
  EXPECT_EQ(play("--log", "/dev/null", "--view", "/dev/null").code, io::kDone);
}

TEST_F(Outputs, OfOtherVerbsDoNotOverwriteTheirInputs) {
  const std::string log = in("game.log");
  ASSERT_EQ(play("--log", log, "--events", in("events.jsonl")).code, io::kDone);
  const std::string again = in("./game.log");
  const std::string events = in("events.jsonl");
  const auto refused = [&](const std::vector<const char*>& arguments, const char* start) {
    expect_refused(answer_to(arguments), start);
  };
  refused({"referee", "log", log.c_str(), "--events", again.c_str()}, "--events");
  refused({"view", log.c_str(), "-o", again.c_str()}, "-o");
  refused({"view", log.c_str(), "--events", events.c_str(), "-o", events.c_str()}, "-o");
  refused({"log", "draw", log.c_str(), "--at", "1", "-o", again.c_str()}, "-o");
  const std::string scene = in("scene.yaml");
  write_content(scene, "schema: 1\nkind: lab\nduration_s: 0.1\n");
  refused({"experiment", "lab", scene.c_str(), "--csv", scene.c_str()}, "--csv");
  EXPECT_TRUE(content_of(log).starts_with("SSL_LOG_FILE"));
}

TEST_F(Outputs, OfReplayDoNotOverwriteTheResults) {
  const std::string sweep = in("sweep.yaml");
  const std::string results = in("results");
  write_content(sweep,
                "schema: 1\nkind: sweep\nseed: 1\npairs: 1\nfactors: { b.robots: [6] }\n"
                "base: { match: { half_s: 1 } }\n");
  ASSERT_EQ(answer_to({"run", sweep.c_str(), "-o", results.c_str(), "-j", "1"}).code, io::kDone);
  for (const char* name : {"effective.yaml", "results.csv", "games/shard-0-of-1.csv"}) {
    const std::string path = results + "/" + name;
    expect_refused(answer_to({"results", "replay", results.c_str(), "b.robots=6-p0001-1", "--log",
                              path.c_str()}),
                   "--log");
  }
}

TEST(SameFile, IsRecognisedHoweverSpelt) {
  const TemporaryFolder folder;
  EXPECT_FALSE(io::is_same_file(folder / "x", folder / "y"));
  EXPECT_FALSE(io::is_same_file(folder / "x", folder / "sub/x"));
  EXPECT_TRUE(io::is_same_file(folder / "sub/../x", folder / "x"));
  fs::create_symlink("loop", folder / "loop");
  EXPECT_FALSE(io::is_same_file(folder / "loop", folder / "x"));
}

}  // namespace
}  // namespace autoref::app
