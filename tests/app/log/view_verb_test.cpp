#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "logs/log_page.hpp"
#include "logs/user_log.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/short_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

class ViewVerb : public testing::Test {
 protected:
  Answer view(const std::string& log, std::vector<const char*> more = {}) {
    std::vector<const char*> arguments = {"view", log.c_str(), "-o", page_.c_str()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return answer_to(arguments);
  }

  TemporaryFolder folder_;
  std::string page_ = folder_ / "game.html";
};

TEST_F(ViewVerb, TurnsALogIntoAPage) {
  const Answer answer = view(write_short_log(folder_, "paper"));
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(answer.out.starts_with(page_)) << answer.out;
  EXPECT_NE(content_of(page_).find(R"x("teams": ["basic (a)", "basic (b)"])x"), std::string::npos);
}

TEST_F(ViewVerb, ShowsWhatPrecedesDamageAndSaysWhereItIs) {
  const std::string log = write_short_log(folder_, "paper");
  const std::string bytes = content_of(log);
  write_content(log, bytes.substr(0, bytes.size() / 2));
  const Answer answer = view(log);
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("the log is only readable up to byte "), std::string::npos)
      << answer.err;
  EXPECT_GT(content_of(page_).size(), 20'000U);
}

TEST_F(ViewVerb, RefusesALogWithoutFrames) {
  const std::string log = folder_ / "empty.log";
  write_content(log, std::string("SSL_LOG_FILE\0\0\0\1", 16));
  const Answer answer = view(log);
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("empty.log: the log contains no vision frame"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(page_));
}

TEST_F(ViewVerb, RefusesAFileThatIsNotALog) {
  const Answer answer = view(in_checkout("README.md"));
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("SSL_LOG_FILE"), std::string::npos) << answer.err;
}

TEST_F(ViewVerb, DoesNotOverwriteTheLog) {
  const std::string log = write_short_log(folder_, "paper");
  const std::string bytes = content_of(log);
  page_ = log;
  EXPECT_EQ(view(log).code, io::kBadInput);
  EXPECT_EQ(content_of(log), bytes);
}

TEST_F(ViewVerb, NamesALineThatIsNotADecision) {
  const std::string events = folder_ / "events.jsonl";
  write_content(events, "no decision\n");
  const Answer answer = view(write_short_log(folder_, "paper"), {"--events", events.c_str()});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("events.jsonl:1:1: "), std::string::npos) << answer.err;
}

TEST_F(ViewVerb, NamesTheLogAndTheBuildThatMadeThePage) {
  view(write_short_log(folder_, "paper"));
  const std::string facts = R"("facts": [["log", "game.log.gz"], ["page made by build", ")" +
                            std::string(io::build_id()) + "\"]";
  EXPECT_NE(content_of(page_).find(facts), std::string::npos);
}

// What the line about the page says of its frames.
struct Shown {
  int frames = 0;
  double duration_s = 0;
};

Shown shown_by(const Answer& answer) {
  Shown shown;
  const std::size_t colon = answer.out.find(": ");
  EXPECT_EQ(std::sscanf(answer.out.c_str() + colon, ": %d frames, %lf s", &shown.frames,
                        &shown.duration_s),
            2)
      << answer.out;
  return shown;
}

TEST_F(ViewVerb, ShowsAPartOfTheLog) {
  const std::string log = write_short_log(folder_, "paper");
  const Shown whole = shown_by(view(log));
  const std::size_t whole_size = content_of(page_).size();
  const Answer answer = view(log, {"--from", "1", "--to", "2"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  const Shown part = shown_by(answer);
  EXPECT_LE(part.duration_s, 1.0);
  EXPECT_GT(part.duration_s, 0.9);
  EXPECT_NEAR(part.frames, whole.frames * part.duration_s / whole.duration_s, 2);
  EXPECT_LT(content_of(page_).size(), whole_size);
}

// The clip begins under the command that was in force.
TEST_F(ViewVerb, BeginsAPartWithTheLastSignalBeforeIt) {
  logs::LogRecorder whole;
  logs::LogRecorder part({.from_s = 1.3, .to_s = 2});
  const std::string log = write_short_log(folder_, "paper");
  logs::read_user_log(log, whole);
  logs::read_user_log(log, part);
  const auto& signals = whole.recording.signals();
  const auto after =
      std::find_if(signals.begin(), signals.end(),
                   [](const view::RecordedSignal& recorded) { return recorded.time_s > 1.3; });
  ASSERT_NE(after, signals.begin());
  ASSERT_FALSE(part.recording.signals().empty());
  EXPECT_EQ(part.recording.signals().front().time_s, 1.3);
  EXPECT_EQ(part.recording.signals().front().signal.command, (after - 1)->signal.command);
}

TEST_F(ViewVerb, RefusesAPartWithoutFrames) {
  const std::string log = write_short_log(folder_, "paper");
  const Answer late = view(log, {"--from", "5000"});
  EXPECT_EQ(late.code, io::kBadInput);
  EXPECT_NE(late.err.find("--from: the log has no frames between these times"), std::string::npos)
      << late.err;
  EXPECT_FALSE(std::filesystem::exists(page_));
  const Answer reversed = view(log, {"--from", "2", "--to", "1"});
  EXPECT_EQ(reversed.code, io::kBadInput);
  EXPECT_NE(reversed.err.find("--to: must be later than --from, 2 s"), std::string::npos)
      << reversed.err;
}

// The page contains the decisions of the game that is played, with their reasons.
TEST_F(ViewVerb, IsAlsoMadeByPlay) {
  const std::string game = in_checkout("scenarios/paper-game.yaml");
  const Answer answer =
      answer_to({"play", game.c_str(), "--set", "match.half_s=3", "--view", page_.c_str()});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_NE(content_of(page_).find(R"("event": "half_over")"), std::string::npos);
}

}  // namespace
}  // namespace autoref::app
