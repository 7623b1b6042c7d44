// autoref play --from.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/errors.hpp"
#include "io/json.hpp"
#include "league/log_contents.hpp"
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

// The log ends with the second half.
TEST_F(PlayFrom, KeepsScoreAndClock) {
  league::LogVisitor nobody;
  const double length_s = league::read_log(log_, nobody).length_s;
  const std::string again = folder_ / "again.log.gz";
  const std::string instant = fmt::format("{}@{}", log_, length_s - 1.5);
  const Answer answer =
      answer_to({"play", "--from", instant.c_str(), "--json", "--log", again.c_str()});
  ASSERT_EQ(answer.code, io::kDone) << answer.err;
  const referee::MidwayStart there = logs::logged_state(log_, length_s - 1.5).start.referee;
  const referee::MidwayStart first = logs::logged_state(again, 0.05).start.referee;
  ASSERT_TRUE(there.signal && first.signal);
  EXPECT_EQ(there.signal->stage, Stage::kSecondHalf);
  EXPECT_EQ(first.signal->stage, there.signal->stage);
  EXPECT_EQ(first.signal->goals, there.signal->goals);
  EXPECT_NEAR(first.signal->stage_time_left_s, there.signal->stage_time_left_s, 0.2);
  EXPECT_LT(io::Json::parse(answer.out)["sim_s"], 3.5);
}

TEST_F(PlayFrom, CountsWhatFollowsInManyGames) {
  const Answer text = play_from(log_ + "@12.5", {"--games", "4", "--workers", "2"});
  ASSERT_EQ(text.code, io::kDone) << text.err;
  EXPECT_TRUE(has(text.out, "4 games from 12.5 s of")) << text.out;
  EXPECT_TRUE(has(text.out, "a goal by basic (yellow)")) << text.out;
  EXPECT_TRUE(has(text.out, "final score: ")) << text.out;
  const Answer answer = play_from(log_ + "@12.5", {"--games", "4", "--seed", "7", "--json"});
  const io::Json json = io::Json::parse(answer.out);
  ASSERT_EQ(json["each"].size(), 4U);
  EXPECT_EQ(json["each"][3]["seed"], 10);
  // A game of many is the same as a single one.
  const Answer single = play_from(log_ + "@12.5", {"--seed", "10", "--json"});
  EXPECT_EQ(io::Json::parse(single.out)["goals_a"], json["each"][3]["goals"]["yellow"]);
}

// At 7 s, play is on.
TEST_F(PlayFrom, LetsASideRepeatTheLog) {
  const Answer answer = play_from(log_ + "@7", {"--ghost", "blue", "--games", "3", "--json"});
  ASSERT_EQ(answer.code, io::kDone) << answer.err;
  const io::Json json = io::Json::parse(answer.out);
  EXPECT_EQ(json["teams"]["blue"], "ghost (blue)");
  EXPECT_FALSE(json.contains("results"));
  EXPECT_GT(json["log"]["lasts_s"], 0);
  EXPECT_TRUE(json["log"]["scorer"].is_null());
  const std::string again = folder_ / "again.log.gz";
  const Answer one = play_from(log_ + "@7", {"--ghost", "blue", "--log", again.c_str()});
  EXPECT_TRUE(has(one.out, "in the log, play ended after")) << one.out;
  for (const double after_s : {0.2, 0.5}) {
    const auto here = logs::logged_state(again, after_s).start.robots[Side::kEast];
    const auto there = logs::logged_state(log_, 7 + after_s).start.robots[Side::kEast];
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < there.size(); ++i)
      EXPECT_LT((here[i].position_m - there[i].position_m).norm(), 0.03) << after_s;
  }
}

TEST_F(PlayFrom, RefusesWhatDoesNotFitManyGamesOrGhosts) {
  const std::string view = folder_ / "view.html";
  const Answer many = play_from(log_ + "@7", {"--games", "3", "--view", view.c_str()});
  EXPECT_EQ(many.code, io::kBadInput);
  EXPECT_TRUE(has(many.err, "--view")) << many.err;
  EXPECT_EQ(play_from(log_ + "@7", {"--ghost", "green"}).code, io::kBadInput);
  const std::string game = in_checkout("scenarios/paper-game.yaml");
  EXPECT_EQ(answer_to({"play", game.c_str(), "--games", "3"}).code, io::kBadInput);
  const Answer stopped = play_from(log_ + "@0.5", {"--ghost", "blue"});
  EXPECT_EQ(stopped.code, io::kBadInput);
  EXPECT_TRUE(has(stopped.err, "play is stopped")) << stopped.err;
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
