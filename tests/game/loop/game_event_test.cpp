#include "game/loop/game_event_fields.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace autoref::game {
namespace {

using referee::Event;
using Fields = std::set<std::string>;

referee::EventDetails all_details() {
  referee::EventDetails details;
  details.robot_m = Vec2(2, 1);
  details.ball_m = Vec2(2.5, -1);
  details.kick_m = Vec2(-1, 0.5);
  details.dribble_from_m = Vec2(0.5, -0.25);
  details.ball_top_m = 0.07;
  details.scorers_touched_s = 11.5;
  details.is_chipped = true;
  details.robots = 6;
  details.robots_allowed = 5;
  details.speed_difference_mps = 0.4;
  details.crash_angle_rad = 3;
  details.waited_s = 10;
  details.to_target_m = 0.05;
  details.from_target_m = 1.8;
  details.own_robot_to_ball_m = 0.6;
  return details;
}

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
  decision.finding.details = all_details();
  return decision;
}

nlohmann::json json_line_of(const referee::Decision& decision) {
  return nlohmann::json::parse(game_event_json(game_event_of(decision).value()));
}

const Fields kGoal = {
    "by_team",       "kicking_team",    "kicking_bot",        "location",
    "kick_location", "max_ball_height", "num_robots_by_team", "last_touch_by_team"};
const Fields kNoGoal = {
    "by_team",         "kicking_team",       "kicking_bot",        "location", "kick_location",
    "max_ball_height", "num_robots_by_team", "last_touch_by_team", "message"};
const Fields kNear = {"by_team", "by_bot", "location", "distance", "ball_location"};

// All fields of the league's messages, except the fouls that caused a MULTIPLE_FOULS.
const std::map<Event, Fields> kFilled = {
    {Event::kGoal, kGoal},
    {Event::kChippedGoal, kNoGoal},
    {Event::kInvalidGoal, kNoGoal},
    {Event::kIndirectGoal, kNoGoal},
    {Event::kFreeKickOwnGoal, kNoGoal},
    {Event::kThrowIn, {"by_team", "by_bot", "location"}},
    {Event::kTouchLineUnknown, {"by_team", "by_bot", "location"}},
    {Event::kCornerKick, {"by_team", "by_bot", "location"}},
    {Event::kGoalKick, {"by_team", "by_bot", "location"}},
    {Event::kGoalLineUnknown, {"by_team", "by_bot", "location"}},
    {Event::kAimlessKick, {"by_team", "by_bot", "location", "kick_location"}},
    {Event::kAttackerTooCloseToDefenseArea, kNear},
    {Event::kAttackerStaysNearArea, kNear},
    {Event::kDefenderInDefenseArea, {"by_team", "by_bot", "location", "distance"}},
    {Event::kDefenderInDefenseAreaPartially, kNear},
    {Event::kAttackerTouchedBallInDefenseArea, {"by_team", "by_bot", "location", "distance"}},
    {Event::kBotKickedBallTooFast,
     {"by_team", "by_bot", "location", "initial_ball_speed", "chipped"}},
    {Event::kBotDribbledBallTooFar, {"by_team", "by_bot", "start", "end"}},
    {Event::kAttackerDoubleTouchedBall, {"by_team", "by_bot", "location"}},
    {Event::kBotCrashUnique,
     {"by_team", "violator", "victim", "location", "crash_speed", "speed_diff", "crash_angle"}},
    {Event::kBotCrashDrawn,
     {"bot_yellow", "bot_blue", "location", "crash_speed", "speed_diff", "crash_angle"}},
    {Event::kDefenderTooCloseToKickPoint, {"by_team", "by_bot", "location", "distance"}},
    {Event::kBotTooFastInStop, {"by_team", "by_bot", "location", "speed"}},
    {Event::kBotInterferedPlacement, {"by_team", "by_bot", "location"}},
    {Event::kPenaltyKickFailed, {"by_team", "location", "reason"}},
    {Event::kBotPushedBot, {"by_team", "violator", "victim", "location", "pushed_distance"}},
    {Event::kNoProgressInGame, {"location", "time"}},
    {Event::kStuckBall, {"location", "time"}},
    {Event::kKeeperHeldBall, {"by_team", "location", "duration"}},
    {Event::kTooManyRobots,
     {"by_team", "num_robots_allowed", "num_robots_on_field", "ball_location"}},
    {Event::kPlacementSucceeded, {"by_team", "time_taken", "precision", "distance"}},
    {Event::kPlacementFailed, {"by_team", "remaining_distance", "nearest_own_bot_distance"}},
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
    const nlohmann::json json = json_line_of(decision_of(entry.event));
    EXPECT_EQ(json["type"], entry.league_event);
    std::string part = json["type"];
    for (char& c : part) c = static_cast<char>(std::tolower(c));
    EXPECT_EQ(filled_in(json[part]), kFilled.at(entry.event)) << entry.name << json.dump();
  }
}

// The values of the league's fields that the finding itself does not have.
TEST(GameEventOfADecision, HasTheDetailsInTheFieldsThatTheLeagueMeans) {
  const auto part = [](Event event, const char* name) {
    return json_line_of(decision_of(event))[name];
  };
  const nlohmann::json robot = {{"x", 2}, {"y", 1}};
  const nlohmann::json ball = {{"x", 2.5}, {"y", -1}};
  const nlohmann::json found = {{"x", 1.5}, {"y", -0.25}};
  const nlohmann::json goal = part(Event::kChippedGoal, "possible_goal");
  EXPECT_EQ(goal["location"], ball);
  EXPECT_EQ(goal["kick_location"], (nlohmann::json{{"x", -1}, {"y", 0.5}}));
  EXPECT_EQ(goal["max_ball_height"], 0.07);
  EXPECT_EQ(goal["num_robots_by_team"], 6);
  EXPECT_EQ(goal["last_touch_by_team"], "11500000");
  const nlohmann::json aimless = part(Event::kAimlessKick, "aimless_kick");
  EXPECT_EQ(aimless["location"], ball);
  EXPECT_EQ(aimless["kick_location"], found);
  EXPECT_EQ(part(Event::kBoundaryCrossing, "boundary_crossing")["location"], ball);
  for (const auto& [event, name] :
       {std::pair(Event::kDefenderInDefenseArea, "defender_in_defense_area"),
        std::pair(Event::kAttackerTouchedBallInDefenseArea,
                  "attacker_touched_ball_in_defense_area"),
        std::pair(Event::kDefenderTooCloseToKickPoint, "defender_too_close_to_kick_point")})
    EXPECT_EQ(part(event, name)["location"], robot) << name;
  const nlohmann::json dribble = part(Event::kBotDribbledBallTooFar, "bot_dribbled_ball_too_far");
  EXPECT_EQ(dribble["start"], (nlohmann::json{{"x", 0.5}, {"y", -0.25}}));
  EXPECT_EQ(dribble["end"], found);
}

TEST(GameEventOfADecision, HasTheMeasurementsInTheFieldsThatTheLeagueMeans) {
  const auto part = [](Event event, const char* name) {
    return json_line_of(decision_of(event))[name];
  };
  const nlohmann::json crash = part(Event::kBotCrashUnique, "bot_crash_unique");
  EXPECT_EQ(crash["crash_speed"], 0.1);
  EXPECT_EQ(crash["speed_diff"], 0.4);
  EXPECT_EQ(crash["crash_angle"], 3);
  const nlohmann::json placed = part(Event::kPlacementSucceeded, "placement_succeeded");
  EXPECT_EQ(placed["time_taken"], 0.1);
  EXPECT_EQ(placed["precision"], 0.05);
  EXPECT_EQ(placed["distance"], 1.8);
  const nlohmann::json failed = part(Event::kPlacementFailed, "placement_failed");
  EXPECT_EQ(failed["remaining_distance"], 0.05);
  EXPECT_EQ(failed["nearest_own_bot_distance"], 0.6);
  const nlohmann::json robots = part(Event::kTooManyRobots, "too_many_robots");
  EXPECT_EQ(robots["num_robots_on_field"], 6);
  EXPECT_EQ(robots["num_robots_allowed"], 5);
  EXPECT_EQ(part(Event::kStuckBall, "no_progress_in_game")["time"], 10);
  EXPECT_EQ(part(Event::kNoProgressInGame, "no_progress_in_game")["time"], 0.1);
  EXPECT_EQ(part(Event::kBotKickedBallTooFast, "bot_kicked_ball_too_fast")["chipped"], true);
}

// Of several robots at fault, the worst one's distance is reported.
TEST(GameEventOfADecision, NamesTheRobotThatWasMeasured) {
  referee::Decision decision = decision_of(Event::kAttackerStaysNearArea);
  decision.finding.offender.reset();
  decision.finding.details.robot = RobotId{Side::kEast, 5};
  const nlohmann::json part = json_line_of(decision)["attacker_too_close_to_defense_area"];
  EXPECT_EQ(part["by_team"], "BLUE");
  EXPECT_EQ(part["by_bot"], 5);
}

TEST(GameEventOfADecision, HasTheFieldsCoordinatesAfterTeamsHaveChangedEnds) {
  referee::Decision decision = decision_of(Event::kGoal);
  decision.blue_on_positive_half = false;
  const nlohmann::json goal = json_line_of(decision)["possible_goal"];
  EXPECT_EQ(goal["location"], (nlohmann::json{{"x", -2.5}, {"y", 1}}));
  EXPECT_EQ(goal["kick_location"], (nlohmann::json{{"x", 1}, {"y", -0.5}}));
}

TEST(GameEventOfADecision, LeavesOutWhatIsUnknown) {
  referee::Decision decision = decision_of(Event::kGoal);
  decision.finding.details = {};
  EXPECT_EQ(filled_in(json_line_of(decision)["possible_goal"]),
            (Fields{"by_team", "kicking_team", "kicking_bot"}));
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
  EXPECT_EQ(json_line_of(decision)["attacker_touched_ball_in_defense_area"]["distance"], 0.04);
}

// The goal of yellow after a restart for blue, who conceded.
TEST(GameEventOfADecision, NamesTheScorer) {
  referee::Decision decision = decision_of(Event::kGoal);
  decision.finding.offender.reset();
  decision.finding.restart = {CommandKind::kPrepareKickoff, Side::kEast};
  EXPECT_EQ(json_line_of(decision)["possible_goal"]["by_team"], "YELLOW");
  EXPECT_EQ(json_line_of(decision)["possible_goal"]["kicking_team"], "BLUE");
}

TEST(GameEventOfADecision, SaysThatTheTeamIsUnknown) {
  referee::Decision decision = decision_of(Event::kTouchLineUnknown);
  decision.last_touch = {};
  const nlohmann::json part = json_line_of(decision)["ball_left_field_touch_line"];
  EXPECT_EQ(part["by_team"], "UNKNOWN");
  EXPECT_FALSE(part.contains("by_bot"));
}

}  // namespace
}  // namespace autoref::game
