#include "game/loop/game_event_fields.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/json.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::game {
namespace {

using referee::Decision;
using referee::Event;
using referee::Finding;

std::uint64_t unix_us(double time_s) {
  return static_cast<std::uint64_t>(std::llround(std::max(0.0, time_s) * 1e6));
}

// Converts a position to vision's coordinates.
std::optional<Vec2> in_field(const std::optional<Vec2>& position_m, const Decision& decision) {
  if (!position_m) return std::nullopt;
  return published(*position_m, decision.blue_on_positive_half);
}

// Sets the team and the robot at fault. If no team is the only offender, the team is that of the
// robot.
void set_offender(const Finding& finding, GameEvent& event) {
  event.by_team = finding.offender;
  if (!finding.details.robot && finding.robots.empty()) return;
  const RobotId robot = finding.details.robot ? *finding.details.robot : finding.robots.front();
  event.by_bot = robot.number;
  if (!event.by_team) event.by_team = robot.side;
}

// The finding's position is where the ball crossed the line.
void set_exit(const Decision& decision, GameEvent& event) {
  event.by_team = decision.last_touch.side;
  if (decision.last_touch.robot) event.by_bot = decision.last_touch.robot->number;
}

// For goals that do not count, the offender is the side that shot: this is the conceding side only
// if it took a free kick into its own goal.
Side scorer_of(const Finding& finding) {
  if (finding.event == Event::kGoal || !finding.offender) return opponent_of(finding.restart.side);
  const bool is_own = finding.event == Event::kFreeKickOwnGoal;
  return is_own ? opponent_of(*finding.offender) : *finding.offender;
}

void set_goal(const Decision& decision, double start_unix_s, GameEvent& event) {
  const Finding& finding = decision.finding;
  const referee::LastTouch& touch = decision.last_touch;
  event.by_team = scorer_of(finding);
  event.kicking_team = touch.side;
  if (touch.robot) event.kicking_bot = touch.robot->number;
  const referee::EventDetails& details = finding.details;
  if (details.scorers_touched_s)
    event.last_touch_by_team_us = unix_us(start_unix_s + *details.scorers_touched_s);
  event.location_m = in_field(details.ball_m, decision);
  event.kick_location_m = in_field(details.kick_m, decision);
  event.max_ball_height_m = details.ball_top_m;
  event.num_robots_by_team = details.robots;
  if (finding.event != Event::kGoal) event.message = finding.evidence;
}

void set_crash(const Finding& finding, GameEvent& event) {
  event.crash_speed_mps = finding.value;
  event.speed_diff_mps = finding.details.speed_difference_mps;
  event.crash_angle_rad = finding.details.crash_angle_rad;
}

void set_both_robots(const Finding& finding, GameEvent& event) {
  for (const RobotId robot : finding.robots)
    (robot.side == Side::kWest ? event.bot_yellow : event.bot_blue) = robot.number;
}

// Robots at fault come first, then their victims.
void set_violator(const Finding& finding, GameEvent& event) {
  event.by_team = finding.offender;
  if (finding.robots.size() < 2) return;
  event.violator = finding.robots[0].number;
  event.victim = finding.robots[1].number;
}

// Sets positions that the league's events use instead of the finding's.
void set_positions(const Decision& decision, GameEvent& event) {
  const referee::EventDetails& details = decision.finding.details;
  const std::optional<Vec2> robot_m = in_field(details.robot_m, decision);
  const std::optional<Vec2> ball_m = in_field(details.ball_m, decision);
  switch (decision.finding.event) {
    case Event::kDefenderInDefenseAreaPartially:
    case Event::kAttackerTooCloseToDefenseArea:
    case Event::kAttackerStaysNearArea:
      event.ball_location_m = ball_m;
      [[fallthrough]];
    case Event::kDefenderInDefenseArea:
    case Event::kAttackerTouchedBallInDefenseArea:
    case Event::kDefenderTooCloseToKickPoint:
      event.location_m = robot_m;
      break;
    case Event::kBotDribbledBallTooFar:
      std::swap(event.location_m, event.end_m);
      event.start_m = in_field(details.dribble_from_m, decision);
      break;
    case Event::kAimlessKick:
      event.kick_location_m = event.location_m;
      [[fallthrough]];
    case Event::kBoundaryCrossing:
      event.location_m = ball_m;
      break;
    default:
      break;
  }
}

// Sets the fields of one robot's offences with a measured value.
void set_offence(const Finding& finding, GameEvent& event) {
  set_offender(finding, event);
  switch (finding.event) {
    case Event::kAttackerTooCloseToDefenseArea:
    case Event::kAttackerStaysNearArea:
      event.distance_m = std::max(0.0, finding.value);
      break;
    case Event::kDefenderInDefenseArea:
    case Event::kDefenderInDefenseAreaPartially:
    case Event::kAttackerTouchedBallInDefenseArea:
      // Signed distances, negative inside; the league counts the depth.
      event.distance_m = -finding.value;
      break;
    case Event::kDefenderTooCloseToKickPoint:
      event.distance_m = finding.value;
      break;
    case Event::kBotKickedBallTooFast:
      event.initial_ball_speed_mps = finding.value;
      event.chipped = finding.details.is_chipped;
      break;
    case Event::kBotTooFastInStop:
      event.speed_mps = finding.value;
      break;
    default:
      break;
  }
}

// Sets the fields of a whole team's fouls. The league's messages for these have no location.
void set_team(const Decision& decision, GameEvent& event) {
  const Finding& finding = decision.finding;
  event.by_team = finding.offender;
  event.location_m.reset();
  switch (finding.event) {
    case Event::kPlacementSucceeded:
      event.time_taken_s = finding.value;
      event.precision_m = finding.details.to_target_m;
      event.distance_m = finding.details.from_target_m;
      break;
    case Event::kPlacementFailed:
      event.remaining_distance_m = finding.details.to_target_m;
      event.nearest_own_bot_distance_m = finding.details.own_robot_to_ball_m;
      break;
    case Event::kTooManyRobots:
      event.num_robots_on_field = finding.details.robots;
      event.num_robots_allowed = finding.details.robots_allowed;
      event.ball_location_m = in_field(finding.details.ball_m, decision);
      break;
    default:
      break;
  }
}

// Sets the fields of all other events: those of a team or of nobody, and offences of robots.
void set_rest(const Decision& decision, GameEvent& event) {
  const Finding& finding = decision.finding;
  switch (finding.event) {
    case Event::kNoProgressInGame:
      event.time_s = finding.value;
      break;
    case Event::kStuckBall:
      event.time_s = finding.details.waited_s;
      break;
    case Event::kKeeperHeldBall:
      event.by_team = finding.offender;
      event.duration_s = finding.value;
      break;
    case Event::kPenaltyKickFailed:
      event.by_team = opponent_of(finding.restart.side);
      event.reason = finding.evidence;
      break;
    case Event::kBoundaryCrossing:
      event.by_team = finding.offender;
      break;
    case Event::kPlacementSucceeded:
    case Event::kPlacementFailed:
    case Event::kTooManyRobots:
    case Event::kMultipleFouls:
    case Event::kMultipleCards:
      set_team(decision, event);
      break;
    default:
      set_offence(finding, event);
  }
  set_positions(decision, event);
}

std::string_view team_name(Side side) { return side == Side::kWest ? "YELLOW" : "BLUE"; }

// Messages contain single-precision numbers: print 0.1 rather than 0.10000000149.
double printed(double number) {
  return std::strtod(fmt::format("{}", static_cast<float>(number)).c_str(), nullptr);
}

io::Json value_json(Side side) { return team_name(side); }
io::Json value_json(int number) { return number; }
io::Json value_json(bool is_true) { return is_true; }
io::Json value_json(double number) { return printed(number); }
io::Json value_json(std::uint64_t number) { return std::to_string(number); }
io::Json value_json(const Vec2& position_m) {
  return {{"x", printed(position_m.x())}, {"y", printed(position_m.y())}};
}

// Collects those members that are set.
struct FieldPrinter {
  io::Json& json;

  template <typename T>
  void operator()(const char* name, const std::optional<T>& value) const {
    if (value) json[name] = value_json(*value);
  }
  void operator()(const char* name, const std::string& text) const {
    if (!text.empty()) json[name] = text;
  }
};

bool has_team(GameEventType type) {
  return type != GameEventType::kNoProgressInGame && type != GameEventType::kBotCrashDrawn &&
         type != GameEventType::kPrepared;
}

}  // namespace

std::optional<GameEvent> game_event_of(const Decision& decision, double start_unix_s) {
  const Finding& finding = decision.finding;
  const std::optional<GameEventType> type =
      game_event_type(referee::entry_of(finding.event).league_event);
  if (!type) return std::nullopt;
  GameEvent event;
  event.type = *type;
  event.origin = {"AutoRef"};
  event.created_us = unix_us(start_unix_s + decision.time_s);
  event.location_m = in_field(finding.position_m, decision);
  switch (*type) {
    case GameEventType::kPossibleGoal:
      set_goal(decision, start_unix_s, event);
      break;
    case GameEventType::kBallLeftFieldTouchLine:
    case GameEventType::kBallLeftFieldGoalLine:
      set_exit(decision, event);
      break;
    case GameEventType::kBotCrashDrawn:
      set_crash(finding, event);
      set_both_robots(finding, event);
      break;
    case GameEventType::kBotCrashUnique:
      set_violator(finding, event);
      set_crash(finding, event);
      break;
    case GameEventType::kBotPushedBot:
      set_violator(finding, event);
      event.pushed_distance_m = finding.value;
      break;
    default:
      set_rest(decision, event);
  }
  return event;
}

std::string game_event_json(const GameEvent& event) {
  io::Json json;
  std::string name(name_of(event.type));
  json["type"] = name.empty() ? io::Json(static_cast<int>(event.type)) : io::Json(name);
  if (!event.origin.empty()) json["origin"] = event.origin;
  if (event.created_us) json["created_timestamp"] = value_json(*event.created_us);
  if (!event.id.empty()) json["id"] = event.id;
  if (name.empty()) return io::json_text(json);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  io::Json& part = json[name] = io::Json::object();
  if (has_team(event.type)) part["by_team"] = "UNKNOWN";
  visit_fields(event, FieldPrinter{part});
  return io::json_text(json);
}

}  // namespace autoref::game
