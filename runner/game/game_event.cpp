#include "runner/game/game_event.hpp"
#include "soccer/published.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::runner {
namespace {

using referee::Decision;
using referee::Event;
using referee::Finding;

std::uint64_t unix_us(double time_s) {
  return static_cast<std::uint64_t>(std::llround(std::max(0.0, time_s) * 1e6));
}

// The first robot of the finding, and its side if nobody is the only offender.
void set_offender(const Finding& finding, GameEvent& event) {
  event.by_team = finding.offender;
  if (finding.robots.empty()) return;
  event.by_bot = finding.robots.front().number;
  if (!event.by_team) event.by_team = finding.robots.front().side;
}

// The finding's position is where the ball crossed the line.
void set_exit(const Decision& decision, GameEvent& event) {
  event.by_team = decision.last_touch.side;
  if (decision.last_touch.robot) event.by_bot = decision.last_touch.robot->number;
}

// For goals that do not count, the offender is the side that shot: the conceding one only if it
// took a free kick into its own goal.
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
  if (touch.side == event.by_team)
    event.last_touch_by_team_us = unix_us(start_unix_s + touch.time_s);
  if (finding.event == Event::kChippedGoal) std::swap(event.location_m, event.kick_location_m);
  const bool is_height = finding.event == Event::kChippedGoal ||
                         (finding.event == Event::kInvalidGoal && finding.unit == "m");
  if (is_height) event.max_ball_height_m = finding.value;
  if (finding.unit == "robots") event.num_robots_by_team = static_cast<int>(finding.value);
}

void set_crash(const Finding& finding, GameEvent& event) {
  event.crash_speed_mps = finding.value;
  for (const RobotId robot : finding.robots)
    (robot.side == Side::kWest ? event.bot_yellow : event.bot_blue) = robot.number;
}

// Robots at fault and their victims come in this order.
void set_violator(const Finding& finding, GameEvent& event) {
  event.by_team = finding.offender;
  if (finding.robots.size() < 2) return;
  event.violator = finding.robots[0].number;
  event.victim = finding.robots[1].number;
}

// Offences of one robot, with a measured value.
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
      event.location_m.reset();  // the finding has the kick's, the league wants the robot's
      break;
    case Event::kBotKickedBallTooFast:
      event.initial_ball_speed_mps = finding.value;
      break;
    case Event::kBotTooFastInStop:
      event.speed_mps = finding.value;
      break;
    case Event::kBotDribbledBallTooFar:
      std::swap(event.location_m, event.end_m);
      break;
    case Event::kAimlessKick:
      std::swap(event.location_m, event.kick_location_m);
      break;
    default:
      break;
  }
}

// Fouls of teams and events of nobody.
void set_rest(const Finding& finding, GameEvent& event) {
  switch (finding.event) {
    case Event::kNoProgressInGame:
      event.time_s = finding.value;
      break;
    case Event::kStuckBall:
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
      event.time_taken_s = finding.value;
      [[fallthrough]];
    case Event::kPlacementFailed:
    case Event::kTooManyRobots:
    case Event::kMultipleFouls:
    case Event::kMultipleCards:
      event.by_team = finding.offender;
      event.location_m.reset();  // the league's messages have none
      break;
    default:
      set_offence(finding, event);
  }
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
  if (finding.position_m)
    event.location_m = published(*finding.position_m, decision.blue_on_positive_half);
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
      break;
    case GameEventType::kBotCrashUnique:
      set_violator(finding, event);
      event.crash_speed_mps = finding.value;
      break;
    case GameEventType::kBotPushedBot:
      set_violator(finding, event);
      event.pushed_distance_m = finding.value;
      break;
    default:
      set_rest(finding, event);
  }
  return event;
}

}  // namespace autoref::runner
