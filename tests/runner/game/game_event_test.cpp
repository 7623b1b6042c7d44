#include "runner/game/game_event.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace autoref::runner {
namespace {

using referee::Event;
using Fields = std::set<std::string>;

// A foul of yellow 3 against blue 5, who touched the ball last; blue's restart.
referee::Decision decision_of(Event event) {
  referee::Decision decision;
  decision.time_s = 12.5;
  decision.finding.event = event;
  decision.finding.value = 0.1;
  decision.finding.robots = {{Side::kWest, 3}, {Side::kEast, 5}};
  decision.finding.offender = Side::kWest;
  decision.finding.position_m = Vec2(1.5, -0.25);
  decision.finding.restart = {CommandKind::kDirectFree, Side::kEast};
  decision.finding.evidence = "because";
  decision.last_touch.side = Side::kEast;
  decision.last_touch.robot = RobotId{Side::kEast, 5};
  return decision;
}

nlohmann::json json_of(const referee::Decision& decision) {
  return nlohmann::json::parse(game_event_json(game_event_of(decision).value()));
}

// The fields that the league's message has and AutoRef knows.
const std::map<Event, Fields> kFilled = {
    {Event::kGoal, {"by_team", "kicking_team", "kicking_bot", "location"}},
    {Event::kChippedGoal,
     {"by_team", "kicking_team", "kicking_bot", "kick_location", "max_ball_height"}},
    {Event::kInvalidGoal, {"by_team", "kicking_team", "kicking_bot", "location"}},
    {Event::kIndirectGoal, {"by_team", "kicking_team", "kicking_bot", "location"}},
    {Event::kFreeKickOwnGoal,
     {"by_team", "kicking_team", "kicking_bot", "location", "last_touch_by_team"}},
    {Event::kThrowIn, {"by_team", "by_bot", "location"}},
    {Event::kTouchLineUnknown, {"by_team", "by_bot", "location"}},
    {Event::kCornerKick, {"by_team", "by_bot", "location"}},
    {Event::kGoalKick, {"by_team", "by_bot", "location"}},
    {Event::kGoalLineUnknown, {"by_team", "by_bot", "location"}},
    {Event::kAimlessKick, {"by_team", "by_bot", "kick_location"}},
    {Event::kAttackerTooCloseToDefenseArea, {"by_team", "by_bot", "location", "distance"}},
    {Event::kAttackerStaysNearArea, {"by_team", "by_bot", "location", "distance"}},
    {Event::kDefenderInDefenseArea, {"by_team", "by_bot", "location", "distance"}},
    {Event::kDefenderInDefenseAreaPartially, {"by_team", "by_bot", "location", "distance"}},
    {Event::kAttackerTouchedBallInDefenseArea, {"by_team", "by_bot", "location", "distance"}},
    {Event::kBotKickedBallTooFast, {"by_team", "by_bot", "location", "initial_ball_speed"}},
    {Event::kBotDribbledBallTooFar, {"by_team", "by_bot", "end"}},
    {Event::kAttackerDoubleTouchedBall, {"by_team", "by_bot", "location"}},
    {Event::kBotCrashUnique, {"by_team", "violator", "victim", "location", "crash_speed"}},
    {Event::kBotCrashDrawn, {"bot_yellow", "bot_blue", "location", "crash_speed"}},
    {Event::kDefenderTooCloseToKickPoint, {"by_team", "by_bot", "distance"}},
    {Event::kBotTooFastInStop, {"by_team", "by_bot", "location", "speed"}},
    {Event::kBotInterferedPlacement, {"by_team", "by_bot", "location"}},
    {Event::kPenaltyKickFailed, {"by_team", "location", "reason"}},
    {Event::kBotPushedBot, {"by_team", "violator", "victim", "location", "pushed_distance"}},
    {Event::kNoProgressInGame, {"location", "time"}},
    {Event::kStuckBall, {"location"}},
    {Event::kKeeperHeldBall, {"by_team", "location", "duration"}},
    {Event::kTooManyRobots, {"by_team"}},
    {Event::kPlacementSucceeded, {"by_team", "time_taken"}},
    {Event::kPlacementFailed, {"by_team"}},
    {Event::kBoundaryCrossing, {"by_team", "location"}},
    {Event::kMultipleFouls, {"by_team"}},
    {Event::kMultipleCards, {"by_team"}}};

Fields filled_in(const nlohmann::json& part) {
  Fields fields;
  for (const auto& [name, value] : part.items()) fields.insert(name);
  return fields;
}

TEST(GameEventOfADecision, FillsTheFieldsOfEveryLeagueEvent) {
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (entry.league_event.empty()) continue;
    ASSERT_TRUE(kFilled.contains(entry.event)) << entry.name;
    const nlohmann::json json = json_of(decision_of(entry.event));
    EXPECT_EQ(json["type"], entry.league_event);
    std::string part = json["type"];
    for (char& c : part) c = static_cast<char>(std::tolower(c));
    EXPECT_EQ(filled_in(json[part]), kFilled.at(entry.event)) << entry.name << json.dump();
  }
}

TEST(GameEventOfADecision, IsMissingIfTheLeagueHasNone) {
  EXPECT_FALSE(game_event_of(decision_of(Event::kOffside)));
  EXPECT_FALSE(game_event_of(decision_of(Event::kHalfOver)));
}

TEST(GameEventOfADecision, IsPrintedAsProtobufWould) {
  EXPECT_EQ(game_event_json(*game_event_of(decision_of(Event::kBotPushedBot), 1'783'000'000)),
            R"({"type": "BOT_PUSHED_BOT", "origin": ["AutoRef"], )"
            R"("created_timestamp": "1783000012500000", "bot_pushed_bot": )"
            R"({"by_team": "YELLOW", "violator": 3, "victim": 5, )"
            R"("location": {"x": 1.5, "y": -0.25}, "pushed_distance": 0.1}})");
}

TEST(GameEventOfADecision, CountsDepthInsideAnArea) {
  referee::Decision decision = decision_of(Event::kAttackerTouchedBallInDefenseArea);
  decision.finding.value = -0.04;
  EXPECT_EQ(json_of(decision)["attacker_touched_ball_in_defense_area"]["distance"], 0.04);
}

// The goal of yellow after a restart for blue, who conceded.
TEST(GameEventOfADecision, NamesTheScorer) {
  referee::Decision decision = decision_of(Event::kGoal);
  decision.finding.offender.reset();
  decision.finding.restart = {CommandKind::kPrepareKickoff, Side::kEast};
  EXPECT_EQ(json_of(decision)["possible_goal"]["by_team"], "YELLOW");
  EXPECT_EQ(json_of(decision)["possible_goal"]["kicking_team"], "BLUE");
}

TEST(GameEventOfADecision, SaysThatTheTeamIsUnknown) {
  referee::Decision decision = decision_of(Event::kTouchLineUnknown);
  decision.last_touch = {};
  const nlohmann::json part = json_of(decision)["ball_left_field_touch_line"];
  EXPECT_EQ(part["by_team"], "UNKNOWN");
  EXPECT_FALSE(part.contains("by_bot"));
}

}  // namespace
}  // namespace autoref::runner
