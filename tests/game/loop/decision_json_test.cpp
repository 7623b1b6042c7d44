#include "game/loop/event_log.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace autoref::game {
namespace {

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
      R"("shootout_kick": null, "rule_changes": null, "teams": {"yellow": {"team": null, "name": null}, )"
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

// A decision without null.
referee::Decision full_decision() {
  referee::Decision decision;
  const RobotId robot{Side::kWest, 1};
  decision.command = Command{CommandKind::kStop};
  decision.stage = Stage::kShootout;
  decision.clock = referee::HalfClock{1, 2};
  decision.shootout_kick = referee::ShootoutKick{};
  decision.card_reason = "3rd foul";
  decision.last_touch = {Side::kWest, robot, 1, 0, 0, robot};
  referee::Finding& finding = decision.finding;
  finding.event = referee::Event::kBotPushedBot;
  finding.rule = "paper 4.2";
  finding.unit = "m";
  finding.robots = {robot};
  finding.offender = Side::kWest;
  finding.card = referee::Card::kYellow;
  finding.position_m = Vec2(1, 2);
  finding.evidence = "A push.";
  decision.from = referee::State::kRun;
  return decision;
}

bool fits(const io::Json& value, std::string_view type) {
  if (type == "REAL") return value.is_number_float();
  if (type == "INTEGER") return value.is_number_integer() || value.is_boolean();
  return type == "TEXT" && (value.is_string() || value.is_structured());
}

TEST(DecisionFields, HaveValuesOfTheirTypes) {
  const EventGame game = {{{EventTeam{"a", "zone"}, EventTeam{"b", "bold"}}},
                          "dribbling 1 m (0.5)"};
  for (const DecisionField& field : decision_fields()) {
    const io::Json value = field.value(full_decision(), game);
    EXPECT_TRUE(fits(value, field.type)) << field.path << ": " << io::json_text(value);
  }
}

TEST(DecisionFields, HaveColumnsOfDifferentNames) {
  std::set<std::string> names = {""};
  for (const DecisionField& field : decision_fields())
    EXPECT_TRUE(names.insert(column_of(field)).second || column_of(field).empty()) << field.path;
  EXPECT_TRUE(names.contains("score_yellow"));      // named after its path
  EXPECT_TRUE(names.contains("position_x_m"));      // has a name of its own
  EXPECT_FALSE(names.contains("last_touch_kept"));  // is left out
}

TEST(DecisionFields, AreDiscardedIfTheirObjectIsNull) {
  const referee::Decision bare;
  for (const DecisionField& field : decision_fields()) {
    const io::Json::json_pointer parent = io::Json::json_pointer(field.path).parent_pointer();
    const bool is_null = decision_object(bare).at(parent).is_null();
    EXPECT_EQ(field.value(bare, {}).is_discarded(), is_null) << field.path;
  }
}

}  // namespace
}  // namespace autoref::game
