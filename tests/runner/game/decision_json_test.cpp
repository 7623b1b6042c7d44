#include "runner/game/event_log.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
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

}  // namespace
}  // namespace autoref::runner
