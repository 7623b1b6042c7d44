// autoref play --from.
#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "logs/logged_state.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/has_part.hpp"
#include "tests/support/short_log.hpp"

namespace autoref::app {
namespace {

class PlayFrom : public testing::Test {
 protected:
  Answer play_from(const std::string& instant, std::vector<const char*> more = {}) {
    std::vector<const char*> arguments = {"play", "--from", instant.c_str(), "--set",
                                          "match.half_s=1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return answer_to(arguments);
  }

  TemporaryFolder folder_;
  std::string log_ = write_short_log(folder_, "paper");
};

TEST_F(PlayFrom, PlaysOnWithAndWithoutAScenario) {
  const Answer without = play_from(log_ + "@12.5", {"--json"});
  EXPECT_EQ(without.code, io::kDone) << without.err;
  const std::string game = in_checkout("scenarios/paper-game.yaml");
  const Answer with = play_from(log_ + "@12.5", {game.c_str(), "--json"});
  EXPECT_EQ(with.code, io::kDone) << with.err;
}

TEST_F(PlayFrom, BeginsWithTheRobotsOfTheLog) {
  const std::string again = folder_ / "again.log.gz";
  ASSERT_EQ(play_from(log_ + "@12.5", {"--log", again.c_str()}).code, io::kDone);
  const auto first = logs::logged_state(again, 0.05).start;
  const auto there = logs::logged_state(log_, 12.5).start;
  for (const Side side : kSides) {
    ASSERT_EQ(first.robots[side].size(), there.robots[side].size());
    for (std::size_t i = 0; i < there.robots[side].size(); ++i) {
      EXPECT_LT((first.robots[side][i].position_m - there.robots[side][i].position_m).norm(), 0.2);
    }
  }
}

TEST_F(PlayFrom, RefusesWhatIsNotAnInstantOfALog) {
  for (const std::string& from : {log_, log_ + "@", log_ + "@soon", std::string("@3")}) {
    const Answer answer = play_from(from);
    EXPECT_EQ(answer.code, io::kBadInput) << from;
    EXPECT_TRUE(has(answer.err, "expected LOG@SECONDS")) << answer.err;
  }
  const Answer beyond = play_from(log_ + "@9999");
  EXPECT_EQ(beyond.code, io::kBadInput);
  EXPECT_TRUE(has(beyond.err, "--from: 9999 s is outside the log")) << beyond.err;
  EXPECT_EQ(play_from("no.log@1").code, io::kBadInput);
}

TEST_F(PlayFrom, RefusesAnotherFieldAndTooFewRobots) {
  const Answer field =
      play_from(log_ + "@12.5", {"--set", "match.rules=2026-b", "--set", "field.length_m=9"});
  EXPECT_TRUE(has(field.err, "the log's field is")) << field.err;
  const Answer robots = play_from(log_ + "@12.5", {"--set", "a.robots=3"});
  EXPECT_TRUE(has(robots.err, "the log has 6 robots of this team")) << robots.err;
}

TEST_F(PlayFrom, DoesNotOverwriteItsLog) {
  EXPECT_EQ(play_from(log_ + "@1", {"--log", log_.c_str()}).code, io::kBadInput);
}

TEST(Play, NeedsAScenarioOrALog) {
  const Answer answer = answer_to({"play"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_TRUE(has(answer.err, "--from LOG@SECONDS")) << answer.err;
}

}  // namespace
}  // namespace autoref::app
