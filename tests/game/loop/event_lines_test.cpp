// The lines of an event log: identical keys, and the state of the game.
#include <gtest/gtest.h>

#include <map>

#include "tests/support/event_lines.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

std::vector<std::string> keys_of(const YAML::Node& line) {
  std::vector<std::string> keys;
  for (const auto& member : line) keys.push_back(member.first.as<std::string>());
  return keys;
}

PerSide<int> goals_in(const YAML::Node& by_colour) {
  return {{by_colour["yellow"].as<int>(), by_colour["blue"].as<int>()}};
}

GameConfiguration knockout(const std::string& strategy) {
  GameConfiguration game = short_game(5, 1);
  game.a.strategy = game.b.strategy = strategy;
  game.match.knockout = true;
  game.match.rules.extra_half_s = 5;
  return game;
}

TEST(EventLines, AllHaveTheSameKeys) {
  for (const char* book : {"paper", "2026-b"}) {
    const PlayedEvents events = played_events(foul_game(book, 2, 60));
    for (const YAML::Node& line : events.lines) {
      ASSERT_EQ(keys_of(line), keys_of(events.lines.front()));
    }
  }
}

TEST(EventLines, SayThatTheRulesAreNotTheOfficialOnes) {
  GameConfiguration game = foul_game("2014", 2, 10);
  EXPECT_TRUE(played_events(game).lines.front()["rule_changes"].IsNull());
  game.match.rules.double_touch_m = 0.15;
  const PlayedEvents events = played_events(game);
  for (const YAML::Node& line : events.lines)
    EXPECT_EQ(line["rule_changes"].as<std::string>(), "double touch 150 mm (50)");
}

// A stop ends play before the time is up; a doubtful call has a confidence below 0.7.
TEST(EventLines, HaveTheStopsAndDoubtfulCallsOfTheRecord) {
  GameConfiguration game = foul_game("2026-b", 2, 60);
  game.sim.vision.ball_noise_m = 0.01;
  const PlayedEvents events = played_events(game);
  int stops = 0;
  int doubtful = 0;
  for (const YAML::Node& line : events.lines) {
    const std::string transition = line["transition"].as<std::string>();
    const bool is_end = transition == "half_over" || transition == "game_over";
    stops +=
        line["from"].as<std::string>() == "RUN" && line["to"].as<std::string>() != "RUN" && !is_end;
    const YAML::Node confidence = line["confidence"];
    doubtful += !confidence.IsNull() && confidence.as<double>() < 0.7;
  }
  EXPECT_GT(stops, 5);
  EXPECT_EQ(events.record.stops, stops);
  EXPECT_EQ(events.record.doubtful_calls, doubtful);
}

TEST(EventLines, ContainTheScoreAfterTheEvent) {
  const PlayedEvents events = played_events(foul_game("paper", 3, 300));
  PerSide<int> goals;
  for (const YAML::Node& line : events.lines) {
    if (line["event"].as<std::string>() == "goal") {
      ++goals[line["command"].as<std::string>() == "GOAL_YELLOW" ? Side::kWest : Side::kEast];
    }
    EXPECT_EQ(goals_in(line["score"]), goals) << line;
  }
  EXPECT_EQ(goals, (PerSide<int>{{events.record.goals_a, events.record.goals_b}}));
  EXPECT_GT(goals[Side::kWest] + goals[Side::kEast], 0);
}

TEST(EventLines, ContainTheStageAndItsClock) {
  const PlayedEvents events = played_events(short_game(30, 1));
  EXPECT_EQ(events.lines.front()["stage"].as<std::string>(), "FIRST_HALF_PRE");
  EXPECT_TRUE(events.lines.front()["clock_s"].IsNull());
  const YAML::Node half_over = events.of("half_over").front();
  EXPECT_EQ(half_over["stage"].as<std::string>(), "FIRST_HALF");
  EXPECT_NEAR(half_over["clock_s"].as<double>(), 30, 0.02);
  EXPECT_EQ(half_over["clock_left_s"].as<double>(), 0);
  for (const YAML::Node& line : events.lines) {
    if (line["clock_s"].IsNull()) continue;
    EXPECT_NEAR(line["clock_s"].as<double>() + line["clock_left_s"].as<double>(), 30, 0.02);
  }
  EXPECT_EQ(events.of("game_over").front()["stage"].as<std::string>(), "SECOND_HALF");
}

TEST(EventLines, NameTheTeams) {
  GameConfiguration game = foul_game("paper", 1, 5);
  game.match.a_plays = Side::kEast;
  const YAML::Node teams = played_events(game).lines.front()["teams"];
  EXPECT_EQ(teams["blue"]["team"].as<std::string>(), "a");
  EXPECT_EQ(teams["blue"]["name"].as<std::string>(), "rowdy");
  EXPECT_EQ(teams["yellow"]["team"].as<std::string>(), "b");
  EXPECT_EQ(teams["yellow"]["name"].as<std::string>(), "basic");
}

TEST(EventLines, DistinguishTwoTeamsWithTheSameStrategy) {
  const YAML::Node teams = played_events(short_game(5, 1)).lines.front()["teams"];
  EXPECT_EQ(teams["yellow"]["name"].as<std::string>(), "basic (a)");
  EXPECT_EQ(teams["blue"]["name"].as<std::string>(), "basic (b)");
}

TEST(EventLines, ListTheKicksOfAShootoutWithItsScore) {
  const PlayedEvents events = played_events(knockout("basic"));
  std::map<std::string, int> kicks;
  PerSide<int> goals;
  for (const YAML::Node& line : events.lines) {
    const YAML::Node kick = line["shootout_kick"];
    EXPECT_EQ(line["shootout"].IsNull(), line["stage"].as<std::string>() != "SHOOTOUT");
    if (kick.IsNull()) continue;
    const auto kicker = kick["kicker"].as<std::string>();
    EXPECT_EQ(kick["number"].as<int>(), ++kicks[kicker]);
    goals[kicker == "yellow" ? Side::kWest : Side::kEast] += kick["scored"].as<bool>() ? 1 : 0;
    EXPECT_EQ(goals_in(line["shootout"]), goals);
  }
  ASSERT_TRUE(events.record.shootout.has_value());
  EXPECT_EQ(goals, (PerSide<int>{{(*events.record.shootout)[0], (*events.record.shootout)[1]}}));
  EXPECT_GE(kicks["yellow"], 3);
}

TEST(EventLines, ReportAMissedKick) {
  const PlayedEvents events = played_events(knockout("dummy"));
  const auto misses = events.of("penalty_kick_failed");
  ASSERT_EQ(misses.size(), 100U);
  EXPECT_FALSE(misses.front()["shootout_kick"]["scored"].as<bool>());
}

}  // namespace
}  // namespace autoref::game
