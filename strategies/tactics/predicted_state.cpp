#include "strategies/tactics/predicted_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/limits.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/skills/strike.hpp"
#include "strategies/tactics/areas.hpp"

namespace autoref::strategies {
namespace {

constexpr double kAmple_m = 100;           // more room than any margins need
constexpr double kPlacedWithin_m = 30_mm;  // error of the ball's placement

// Adds both areas as discs that touch the areas' front lines, each unless the robot or its target
// is inside that area.
void add_areas(const PredictedState& predicted, const TrackedRobot& robot, const Vec2& target_m,
               Obstacles& obstacles) {
  for (const Side side : kSides) {
    const Vec2 goal_m = predicted.field().goal_centre_m(side);
    const double apart_m = side == Side::kEast ? predicted.limits().keep_from_area_m : 0;
    const double radius_m =
        predicted.field().defence_area.depth_m + std::max(apart_m, predicted.style().off_area_m);
    if ((robot.position_m - goal_m).norm() > radius_m && (target_m - goal_m).norm() > radius_m)
      obstacles.push_back({goal_m, radius_m});
  }
}

}  // namespace

PredictedState::PredictedState(const TeamContext& context, const Style& style)
    : context_(context), style_(style), look_ahead_(context.robots, context.frame_rate_hz) {}

void PredictedState::update(const TeamView& view) {
  if (look_ahead_.look(view, now_)) {
    path_.follow(now_.ball, 0);
  } else {
    path_.follow(view.ball, view.latency_s);
    now_.ball.position_m = path_.now_m();
  }
  position_m_ = now_.placement_m.value_or(now_.ball.position_m);
  intercept_ball();
  settle_possession();
  threat_m_ = find_threat_m();
  room_at_ball_m_ = find_room_at_ball_m();
  limits_ = find_limits();
}

const Abilities& PredictedState::abilities(int index) const {
  return context_.robots[static_cast<std::size_t>(robot(index).number)];
}

// To save time, each opponent is updated only every other frame.
void PredictedState::intercept_ball() {
  for (int i = 0; i < robots(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    interceptions_[at] = intercept(robot(i), path_, abilities(i), field());
  }
  theirs_ = {path_.end_m(), std::numeric_limits<double>::infinity()};
  their_fastest_ = -1;
  static const Abilities kUsual;
  for (int i = 0; i < static_cast<int>(now_.opponents.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if ((now_.frame + i) % 2 == 0 || their_interceptions_[at].time_s <= 0)
      their_interceptions_[at] = intercept(now_.opponents[at], path_, kUsual, field());
    if (their_interceptions_[at].time_s >= theirs_.time_s) continue;
    theirs_ = their_interceptions_[at];
    their_fastest_ = i;
  }
}

void PredictedState::settle_possession() {
  if (now_.play != Play::kRunning) {
    is_ours_ = restart_is_ours();
    return;
  }
  double ours_s = std::numeric_limits<double>::infinity();
  for (int i = 0; i < robots(); ++i) ours_s = std::min(ours_s, interception(i).time_s);
  // The margin favours the team that has the ball (hysteresis).
  is_ours_ = ours_s <
             theirs_.time_s + (is_ours_ ? style_.possession_margin_s : -style_.possession_margin_s);
}

Vec2 PredictedState::find_threat_m() const {
  if (now_.play != Play::kRunning || is_ours_ || their_fastest_ < 0) return position_m_;
  const TrackedRobot& fastest = now_.opponents[static_cast<std::size_t>(their_fastest_)];
  if (theirs_.time_s <= 0 || has_ball(fastest, path_.now_m()))
    return position_m_ + fastest.velocity_mps * style_.threat_lead_s;
  return position_m_ + style_.anticipation * (theirs_.point_m - position_m_);
}

bool PredictedState::is_waiting() const {
  return now_.play == Play::kStop || now_.play == Play::kHalt ||
         now_.play == Play::kPrepareKickoff || now_.play == Play::kPreparePenalty;
}

bool PredictedState::restart_is_ours() const {
  return now_.play == Play::kStop ? now_.next_is_ours : now_.ours;
}

double PredictedState::find_room_at_ball_m() const {
  if (now_.play == Play::kRunning) return 0;
  if (now_.ours && is_restart(now_.play)) return 0;
  return least_room_at_ball_m() + style_.ball_margin_m * share_of_margins();
}

double PredictedState::least_room_at_ball_m() const {
  const bool is_judged = rules().has(RuleId::kDefenderTooCloseToKickPoint);
  return rules().opponents_to_ball_m + (is_judged ? kBallRadius_m : 0.0) +
         room_for_error_m(rules());
}

// A robot between the ball and the area has to keep from both.
double PredictedState::room_behind_kick_m() const {
  if (!style_.narrow_wall || !awaits_their_free_kick() ||
      !rules().has(RuleId::kDefenderTooCloseToKickPoint))
    return kAmple_m;
  const double needed_m = least_room_at_ball_m() + 2 * kRobotRadius_m;
  if (rules().free_kick_to_area_m > needed_m + all_margins_m()) return kAmple_m;
  const double to_area_m = distance_to_defence_area(field(), Side::kWest, position_m());
  const bool is_placed = to_area_m > rules().free_kick_to_area_m - kPlacedWithin_m;
  return is_placed ? to_area_m - needed_m : kAmple_m;
}

bool PredictedState::awaits_their_free_kick() const {
  if (restart_is_ours()) return false;
  if (now_.play != Play::kStop)
    return now_.play == Play::kDirectFree || now_.play == Play::kIndirectFree;
  return now_.next == CommandKind::kDirectFree || now_.next == CommandKind::kIndirectFree;
}

double PredictedState::all_margins_m() const { return style_.ball_margin_m + 2 * kLimitMargin_m; }

double PredictedState::share_of_margins() const {
  if (has_no_room_behind_kick()) return 0;
  return std::min(1.0, room_behind_kick_m() / all_margins_m());
}

bool PredictedState::has_no_room_behind_kick() const {
  return room_behind_kick_m() < 2 * kNarrowMargin_m;
}

Limits PredictedState::find_limits() const {
  Limits limits;
  if (now_.play == Play::kRunning) return limits;
  limits.own_half_only = now_.play == Play::kPrepareKickoff || now_.play == Play::kKickoff ||
                         now_.next == CommandKind::kPrepareKickoff;
  if (restart_is_ours()) limits.beyond_lines_m = style_.beyond_line_m;
  const double room_m = room_at_ball_m_;
  limits.keep_from_ball_m = room_m > 0 ? room_m + kRobotRadius_m : style_.room_for_taker_m;
  limits.own_area_margin_m = std::max(kNarrowMargin_m, kLimitMargin_m * share_of_margins());
  limits.keep_from_area_m = rules().attacker_to_area_m + kRobotRadius_m +
                            room_for_error_m(rules()) + style_.area_margin_m;
  return limits;
}

DrivingStyle PredictedState::driving(int index) const {
  const Abilities& a = abilities(index);
  DrivingStyle style;
  style.speed_mps = a.speed_mps;
  style.braking_mps2 = style_.usable_braking * a.braking_mps2;
  style.turn_braking_radps2 = style_.turn_braking_radps2;
  style.approach_per_s = style_.approach_per_s;
  if (now_.play == Play::kStop && rules().has(RuleId::kBotTooFastInStop))
    style.speed_mps = std::min(a.speed_mps, style_.stop_speed_share * rules().stop_speed_mps);
  return style;
}

// Adds a margin outside the areas' lines, because the whole hull must stay outside.
bool PredictedState::may_touch_at(const Vec2& ball_m) const {
  if (rules().has(RuleId::kAttackerTouchedBallInDefenseArea) &&
      distance_to_defence_area(field(), Side::kEast, ball_m) < style_.from_their_area_m)
    return false;
  return !rules().has(RuleId::kDefenderInDefenseArea) || robots() == 1 ||
         distance_to_defence_area(field(), Side::kWest, ball_m) > style_.from_own_area_m;
}

double PredictedState::allowed_kick_mps(double wanted_mps) const {
  if (!rules().has(RuleId::kBotKickedBallTooFast))
    return std::min(wanted_mps, rules().kick_limit_mps);
  const double share = std::min(style_.kick_caution, share_below_limit(context_.kicks.speed));
  return std::min(wanted_mps, share * rules().kick_limit_mps);
}

void robots_around(const PredictedState& predicted, int index, const Vec2& target_m,
                   Obstacles& obstacles) {
  const TeamView& now = predicted.now();
  find_obstacles(
      {now.own, now.opponents, 0, now.ball.position_m, farthest_between_walls_m(predicted.field())},
      predicted.robot(index), target_m, obstacles);
}

Waypoint facing_ball(const PredictedState& predicted, const Vec2& position_m) {
  return {position_m, direction_of(predicted.position_m() - position_m, Vec2(1, 0))};
}

RobotCommand go_to(const PredictedState& predicted, int index, const Waypoint& wanted) {
  const TrackedRobot& robot = predicted.robot(index);
  const TeamView& now = predicted.now();
  Waypoint goal = wanted;
  goal.position_m = permitted_by_all(predicted.field(), wanted.position_m, predicted.position_m(),
                                     predicted.limits());
  if (const auto path_m = exit_from_behind_goal(predicted.field(), robot.position_m))
    goal.position_m = *path_m;
  if (const auto path_m = exit_from_goal(predicted, robot)) {
    return drive_via(robot, *path_m, {*path_m, robot.heading}, predicted.driving(index));
  }
  Obstacles obstacles;
  const double room_m = std::max(predicted.style().near_room_m, predicted.room_at_ball_m());
  find_obstacles({now.own, now.opponents, room_m, now.ball.position_m,
                  farthest_between_walls_m(predicted.field())},
                 robot, goal.position_m, obstacles);
  add_areas(predicted, robot, goal.position_m, obstacles);
  const DrivingStyle style = predicted.driving(index);
  const Vec2 off_m = robot.position_m - now.ball.position_m;
  if (room_m > predicted.style().near_room_m &&
      off_m.norm() < room_m + kRobotRadius_m - predicted.style().near_room_m) {
    // The robot first leaves the circle around the ball, either directly or along a wall that is in
    // the way.
    const Vec2 out =
        off_walls(predicted.field(), robot.position_m, direction_of(off_m, Vec2(-1, 0)),
                  room_m + kRobotRadius_m - off_m.norm());
    return drive_via(robot, robot.position_m + out * predicted.style().near_room_m * 10, goal,
                     style);
  }
  const Vec2 via_m = around_boxes(predicted, robot, goal.position_m);
  const Vec2 steer_m = steer_for(robot, via_m, obstacles);
  return drive_via(robot, steer_m, goal, style);
}

namespace {

// How gently robots approach opponents.
Easing easing_of(const PredictedState& predicted) {
  const Style& style = predicted.style();
  Easing easing{style.ease_from_m, style.gentle_mps, style.ease_mps2};
  if (predicted.rules().fouls_per_card == 0) return easing;
  easing.from_m = std::max(easing.from_m, style.card_ease_from_m);
  easing.gentle_mps = std::min(easing.gentle_mps, style.card_gentle_mps);
  easing.braking_mps2 = std::min(easing.braking_mps2, style.card_ease_mps2);
  if (predicted.rules().has(RuleId::kBotPushedBot)) easing.contact_mps = style.contact_mps;
  return easing;
}

}  // namespace

// A robot in contact with an opponent presses no harder than the style allows.
void ease_off(const PredictedState& predicted, int index, RobotCommand& command) {
  ease_off(predicted.robot(index), predicted.now().opponents, easing_of(predicted), command);
}

}  // namespace autoref::strategies
