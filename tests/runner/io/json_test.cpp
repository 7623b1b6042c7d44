#include "runner/io/json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "runner/game/event_log.hpp"
#include "runner/results/game_report.hpp"

namespace autoref::runner {
namespace {

TEST(Json, EscapesTexts) { EXPECT_EQ(json_text("a\"b\\c\n\x01"), R"("a\"b\\c\n\u0001")"); }

TEST(Json, ReplacesWhatIsNotUtf8) { EXPECT_EQ(json_text("a\xff"), "\"a\xef\xbf\xbd\""); }

TEST(Json, IsOneLineInTheOrderOfItsMembers) {
  EXPECT_EQ(json_text({{"z", {1, true, nullptr}}, {"a", Json::object()}}),
            R"({"z": [1, true, null], "a": {}})");
}

TEST(Json, WritesTheShortestNumberThatReadsBackEqual) {
  for (const double number : {0.1, 1.0 / 3, -2e-300, 5e-324, 1.7976931348623157e308, 123456789.0})
    EXPECT_EQ(Json::parse(json_text(number)).get<double>(), number);
  EXPECT_EQ(json_text(0.1), "0.1");
  EXPECT_EQ(json_text(2.0), "2");
}

TEST(Json, WritesNullForNumbersThatAreNotFinite) {
  EXPECT_EQ(json_text(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(json_text(-std::numeric_limits<double>::infinity()), "null");
}

TEST(Json, RoundsToDecimals) {
  EXPECT_EQ(json_text(rounded(12.3456, 2)), "12.35");
  EXPECT_EQ(json_text(rounded(-0.75, 0)), "-1");
}

TEST(DecisionJson, WritesNullForUnknownValues) {
  referee::Decision decision;
  decision.transition = "T1";
  decision.finding.rule = "paper 4.2";
  EXPECT_EQ(
      decision_json(decision),
      R"({"time_s": 0, "stage": "FIRST_HALF_PRE", "clock_s": null, "clock_left_s": null, )"
      R"("score": {"yellow": 0, "blue": 0}, "shootout": null, "transition": "T1", "from": "INIT", "to": "INIT", "command": null, )"
      R"("event": "begin", "league_event": null, "rule": "paper 4.2", "value": null, "threshold": null, )"
      R"("unit": null, "confidence": null, "robots": [], "offender": null, "card": null, "card_reason": null, )"
      R"("position_m": null, "yellow_defends": "west", "restart": null, "last_touch": null, "evidence": null, )"
      R"("shootout_kick": null, "teams": {"yellow": {"team": null, "name": null}, )"
      R"("blue": {"team": null, "name": null}}})");
}

TEST(DecisionJson, NamesRobotsByColourAndNumber) {
  referee::Decision decision;
  decision.command = Command{CommandKind::kDirectFree, Side::kEast};
  decision.finding.value = 0.25;
  decision.finding.unit = "m";
  decision.finding.robots.push_back({Side::kWest, 3});
  decision.finding.position_m = Vec2(1.5, -2);
  decision.last_touch.side = Side::kWest;
  const std::string json = decision_json(decision);
  EXPECT_NE(json.find(R"("command": "DIRECT_FREE_BLUE")"), std::string::npos);
  EXPECT_NE(json.find(R"("robots": [{"colour": "yellow", "number": 3}])"), std::string::npos);
  EXPECT_NE(json.find(R"("position_m": [1.5, -2])"), std::string::npos);
  EXPECT_NE(json.find(R"("last_touch": {"colour": "yellow", "robot": null)"), std::string::npos);
  EXPECT_NE(json.find(R"("value": 0.25)"), std::string::npos);
}

TEST(DecisionJson, WritesUnknownIfTheToucherIsUnknown) {
  referee::Decision decision;
  decision.last_touch.time_s = 12.5;
  const std::string json = decision_json(decision);
  EXPECT_NE(json.find(R"("last_touch": {"colour": "unknown", "robot": null, "time_s": 12.5)"),
            std::string::npos)
      << json;
}

TEST(GameReport, HasTheKeysOfAGame) {
  GameConfiguration game;
  GameRecord record;
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
  GameConfiguration game;
  game.match.a_plays = Side::kEast;
  game.match.rules = *find_rule_book("2014");
  game.seed = 7;
  const std::string json = json_of({game, {}, 2.0, "x"});
  EXPECT_NE(json.find(R"x("rules": "2014", "seed": 7, "teams": {"a": {"name": "basic (a)", )x"
                      R"x("strategy": "basic", "colour": "blue", "side": "east"}, "b": {)x"
                      R"x("name": "basic (b)", "strategy": "basic", "colour": "yellow", )x"
                      R"x("side": "west"}})x"),
            std::string::npos)
      << json;
}

TEST(GameReport, ShowsTheScore) {
  GameConfiguration game;
  game.match.a_plays = Side::kEast;
  GameRecord record;
  record.goals_a = 3;
  EXPECT_TRUE(
      text_of({game, record, 2.0, "x"}).starts_with("a (basic, east)  3 : 0  b (basic, west)"));
}

TEST(GameReport, ShowsThePlayCountsOfBothTeams) {
  GameConfiguration game;
  GameRecord record;
  record.counts[0] = {12, 7, 30, 21, 300, 3, 5};
  record.counts[1] = {8, 2, 25, 9, 200, 4, 6};
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
}  // namespace autoref::runner
