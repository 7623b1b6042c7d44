#include "experiments/results/game_report.hpp"

#include <gtest/gtest.h>

namespace autoref::experiments {
namespace {

TEST(GameReport, HasTheKeysOfAGame) {
  game::GameConfiguration game;
  game::GameRecord record;
  record.goals_a = 3;
  record.goals_b = 1;
  record.goals_by_half = {{1, 0}, {2, 1}};
  record.events[static_cast<std::size_t>(referee::Event::kThrowIn)] = 4;
  record.counts[1].shots = 5;
  record.counts[1].possession_s = 250.5;
  record.sim_s = 1200;
  record.state_hash = 0xabc;
  const std::string json = json_of({game, record, 2.0, "0.1.0-x"});
  EXPECT_TRUE(json.starts_with(
      R"({"goals_a": 3, "goals_b": 1, "goals_by_half": [[1, 0], [2, 1]], "end_reason": "time", )"));
  EXPECT_NE(json.find(R"("throw_in": 4)"), std::string::npos);
  EXPECT_NE(json.find(R"("shots_a": 0, "shots_b": 5, )"), std::string::npos);
  EXPECT_NE(json.find(R"("possession_s_b": 250.5, )"), std::string::npos);
  EXPECT_NE(json.find(R"("x_real_time": 600)"), std::string::npos);
  EXPECT_TRUE(json.ends_with(R"("state_hash": "0000000000000abc", "build": "0.1.0-x"})"));
}

TEST(GameReport, NamesTheTeamsTheSeedAndTheRuleBook) {
  game::GameConfiguration game;
  game.match.a_plays = Side::kEast;
  game.match.rules = *find_rule_book("2014");
  game.seed = 7;
  const std::string json = json_of({game, {}, 2.0, "x"});
  EXPECT_NE(
      json.find(
          R"x("rules": "2014", "rule_changes": null, "seed": 7, "teams": {"a": {"name": "basic (a)", )x"
          R"x("strategy": "basic", "colour": "blue", "side": "east"}, "b": {)x"
          R"x("name": "basic (b)", "strategy": "basic", "colour": "yellow", )x"
          R"x("side": "west"}})x"),
      std::string::npos)
      << json;
}

TEST(GameReport, SaysThatTheRulesAreNotTheOfficialOnes) {
  game::GameConfiguration game;
  game.match.rules = *find_rule_book("2014");
  game.match.rules.double_touch_m = 0.15;
  const std::string json = json_of({game, {}, 2.0, "x"});
  EXPECT_NE(json.find(R"x("rule_changes": "double touch 150 mm (50)")x"), std::string::npos);
  EXPECT_NE(text_of({game, {}, 2.0, "x"})
                .find("\nnot the official rules: double touch 150 mm (50)\nended: "),
            std::string::npos);
}

TEST(GameReport, ShowsTheScore) {
  game::GameConfiguration game;
  game.match.a_plays = Side::kEast;
  game::GameRecord record;
  record.goals_a = 3;
  EXPECT_TRUE(
      text_of({game, record, 2.0, "x"}).starts_with("a (basic, east)  3 : 0  b (basic, west)"));
}

TEST(GameReport, ShowsThePlayCountsOfBothTeams) {
  game::GameConfiguration game;
  game::GameRecord record;
  record.counts[0] = {.shots = 12,
                      .shots_on_goal = 7,
                      .passes_tried = 30,
                      .passes_completed = 21,
                      .possession_s = 300,
                      .fouls = 3,
                      .duels_won = 5};
  record.counts[1] = {.shots = 8,
                      .shots_on_goal = 2,
                      .passes_tried = 25,
                      .passes_completed = 9,
                      .possession_s = 200,
                      .fouls = 4,
                      .duels_won = 6};
  record.ball_in_play_s = 500;
  EXPECT_NE(text_of({game, record, 2.0, "x"}).find(R"(
                      a      b
shots                12      8
  on goal             7      2
passes tried         30     25
  completed          21      9
possession         60 %   40 %
fouls                 3      4
duels won             5      6
)"),
            std::string::npos);
}

}  // namespace
}  // namespace autoref::experiments
