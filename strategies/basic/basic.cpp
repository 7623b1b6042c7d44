#include "strategies/basic/basic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "strategies/skills/limits.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/skills/prediction.hpp"
#include "strategies/strategy.hpp"
#include "strategies/tactics/penalty.hpp"

namespace autoref::strategies::basic {
namespace {

constexpr double kTakerWaits_m = 0.5;  // distance from the ball within which a restart's taker
                                       // stands still
constexpr int kSidesteps = 12;         // maximum number of sidesteps from the ball's path to the
                                       // goal

// If kicks above the limit are fouls, the team's kicks stay below it by more than the kickers'
// error.
Style within_the_rules(Style style, const RuleBook& rules, const KickScatter& kicks) {
  const double share = rules.has(RuleId::kBotKickedBallTooFast)
                           ? std::min(style.kick_caution, share_below_limit(kicks.speed))
                           : 1.0;
  style.shot_mps = std::min(style.shot_mps, rules.kick_limit_mps * share);
  style.pass_mps = std::min(style.pass_mps, rules.kick_limit_mps * share);
  return style;
}

}  // namespace

Basic::Basic(const TeamContext& context)
    : context_(context),
      style_(within_the_rules(tuned(Style{}, context.params), context.rules, context.kicks)),
      look_ahead_(context.robots, context.frame_rate_hz) {}

// The distance from a hull to the ball's centre required at restarts. If the rule is in force, this
// distance is larger, because referees measure to the ball's surface.
double Basic::room_at_ball_m() const {
  const bool is_judged = context_.rules.has(RuleId::kDefenderTooCloseToKickPoint);
  return context_.rules.opponents_to_ball_m + (is_judged ? kBallRadius_m : 0.0) +
         room_for_error_m(context_.rules);
}

Limits Basic::limits_for(bool is_keeper) const {
  Limits limits;
  limits.may_enter_own_area = is_keeper;
  limits.may_stay_behind_goal = true;
  if (now_.play == Play::kRunning) return limits;
  limits.own_half_only = now_.play == Play::kPrepareKickoff || now_.play == Play::kKickoff;
  const bool may_come_near = now_.ours && is_restart(now_.play);
  limits.keep_from_ball_m = may_come_near ? 0 : room_at_ball_m() + kRobotRadius_m;
  limits.keep_from_area_m =
      context_.rules.attacker_to_area_m + kRobotRadius_m + room_for_error_m(context_.rules);
  return limits;
}

// Lists the obstacles, once per decision. Robots need not exclude themselves, since a robot is at
// no distance along its own path.
void Basic::find_obstacles() {
  const double clearance_m = 2 * kRobotRadius_m + style_.robot_gap_m;
  robots_.clear();
  robots_.farthest_m = farthest_between_walls_m(context_.field);
  for (const TrackedRobot& mate : now_.own) robots_.push_back({mate.position_m, clearance_m});
  for (const TrackedRobot& opponent : now_.opponents) {
    robots_.push_back({opponent.position_m, clearance_m});
  }
  robots_and_ball_ = robots_;
  const double room_m = now_.play == Play::kRunning ? style_.ball_gap_m : room_at_ball_m();
  robots_and_ball_.push_back({now_.ball.position_m, kRobotRadius_m + room_m});
}

Waypoint Basic::waypoint_of(int index, const RoleAssignment& assignment) const {
  const AssignedRole& role = assignment.roles[index];
  switch (role.role) {
    case Role::kKeeper:
      return keeper_position(context_.field, style_, now_.ball);
    case Role::kAttacker:
    case Role::kWall:
      return wall_position(context_.field, style_, ball_target_m_, role.rank);
    case Role::kSupporter:
      return supporter_position(context_.field, style_, ball_target_m_, role.rank);
    case Role::kMarker:
      return marker_position(context_.field, style_, now_.opponents[role.marks], ball_target_m_);
  }
  return {};
}

bool Basic::is_pressed() const {
  return std::any_of(now_.opponents.begin(), now_.opponents.end(), [&](const TrackedRobot& o) {
    return (o.position_m - now_.ball.position_m).norm() < style_.duel_m;
  });
}

// Kick speed for a pass that arrives slowly enough to be received.
double Basic::pass_speed_mps(double distance_m) const {
  return std::min(style_.pass_mps,
                  style_.slowest_pass_mps + style_.pass_per_metre_per_s * distance_m);
}

// The team-mate with the safest pass, excluding those behind the ball; nullopt if no team-mate can
// receive a pass.
std::optional<Aim> Basic::best_pass(int passer) const {
  std::optional<Aim> best;
  for (const TrackedRobot& mate : now_.own) {
    if (mate.number == passer ||
        mate.position_m.x() < now_.ball.position_m.x() - style_.back_pass_m) {
      continue;
    }
    const double lane_m = lane_clearance_m(now_.ball.position_m, mate.position_m, now_.opponents);
    if (lane_m > (best ? best->clearance_m : style_.pass_lane_m))
      best = Aim{mate.position_m, lane_m};
  }
  return best;
}

// The kick to choose: a shot if the goal is open, otherwise a pass, otherwise a push towards the
// goal that stays in play.
Intent Basic::attack_intent(const TrackedRobot& attacker) const {
  const Vec2& ball_m = now_.ball.position_m;
  TrackedRobots others = now_.opponents;  // team-mates also block shots
  for (const TrackedRobot& mate : now_.own) {
    if (mate.number != attacker.number && others.size() < others.capacity()) others.push_back(mate);
  }
  Aim aim = best_shot(context_.field, ball_m, others);
  double kick_mps = style_.shot_mps;
  if (aim.clearance_m < style_.shot_lane_m) {
    const std::optional<Aim> pass = best_pass(attacker.number);
    kick_mps = pass ? pass_speed_mps((pass->target_m - ball_m).norm()) : style_.push_mps;
    aim = pass ? *pass : best_push(context_.field, ball_m, now_.opponents);
  }
  Intent intent{aim.target_m, kick_mps};
  const double distance_m = std::max(0.1, (aim.target_m - ball_m).norm());
  // The tolerance is a fraction of the angle that the free lane subtends, as seen from the ball.
  intent.tolerance_rad = std::clamp(
      style_.aim_share * std::min(aim.clearance_m, style_.free_lane_m) / distance_m, 0.04, 0.2);
  if (is_pressed() && now_.play == Play::kRunning) intent.hasty_mps = style_.push_mps;
  // A ball that is pushed along before it is kicked would count as being touched twice.
  const bool touches_once = context_.rules.has(RuleId::kAttackerDoubleTouchedBall);
  if (touches_once && is_restart(now_.play)) intent.hasty_mps = kick_mps;
  return intent;
}

RobotCommand Basic::attack(const RoleAssignment& assignment) const {
  const TrackedRobot& robot = now_.own[assignment.attacker];
  const Obstacles& obstacles = robots_;
  if (now_.play == Play::kRunning && comes_at(robot, now_.ball)) {
    return receive_ball(robot, now_.ball, assignment.interception.point_m, obstacles, driving_);
  }
  return play_ball(robot, now_.ball, assignment.interception.point_m, attack_intent(robot),
                   obstacles, driving_);
}

RobotCommand Basic::keep(int index, const RoleAssignment& assignment) const {
  const TrackedRobot& robot = now_.own[index];
  const Vec2& ball_m = now_.ball.position_m;
  const bool ball_in_area =
      distance_to_defence_area(context_.field, Side::kWest, ball_m) < style_.keeper_area_margin_m &&
      ball_m.x() > -context_.field.half_length_m();
  if (ball_in_area && now_.play == Play::kRunning &&
      now_.ball.velocity_mps.norm() < style_.keeper_fetch_mps) {
    const Vec2 away_m =
        ball_m + direction_of(ball_m - context_.field.goal_centre_m(Side::kWest), Vec2(1, 0));
    return play_ball(robot, now_.ball, intercept(robot, now_.ball).point_m,
                     {away_m, style_.clearance_mps, 0.5}, robots_, driving_);
  }
  return drive_to(robot, waypoint_of(index, assignment), {}, driving_);
}

// Whether the attacker can go for the ball now without breaking a rule.
bool Basic::may_play_ball() const {
  if (now_.play != Play::kRunning) return now_.ours && is_restart(now_.play);
  const double to_area_m =
      distance_to_defence_area(context_.field, Side::kWest, now_.ball.position_m);
  const bool is_theirs = context_.rules.has(RuleId::kAttackerTouchedBallInDefenseArea) &&
                         distance_to_defence_area(context_.field, Side::kEast,
                                                  now_.ball.position_m) < style_.from_their_area_m;
  return !is_theirs && (now_.own.size() == 1 || to_area_m > kFrontDistance_m);
}

// The number of the robot that must not touch the ball; -1 if all robots may.
int Basic::barred_from_ball() const {
  const bool is_barred = now_.play == Play::kRunning && now_.own.size() > 1 &&
                         context_.rules.has(RuleId::kAttackerDoubleTouchedBall);
  return is_barred ? taker_.number() : -1;
}

// Whether the robot might run into a ball that it must not touch.
bool Basic::must_wait(const TrackedRobot& robot) const {
  return robot.number == barred_from_ball() &&
         (robot.position_m - now_.ball.position_m).norm() < kTakerWaits_m;
}

void Basic::avoid_contact(TeamCommands& commands) const {
  if (now_.play != Play::kRunning || !context_.rules.has(RuleId::kBotCrashUnique)) return;
  for (const TrackedRobot& robot : now_.own)
    ease_off(robot, now_.opponents, {}, commands[robot.number]);
}

void Basic::play(TeamCommands& commands) {
  const RoleAssignment assignment =
      assign_roles(now_, context_.field, style_, former_attacker_, barred_from_ball());
  former_attacker_ = assignment.attacker < 0 ? -1 : now_.own[assignment.attacker].number;
  taker_.update(now_, now_.ours && is_restart(now_.play) ? former_attacker_ : -1);
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    const TrackedRobot& robot = now_.own[i];
    RobotCommand& command = commands[robot.number];
    const Role role = assignment.roles[i].role;
    if (must_wait(robot)) continue;
    if (const auto path_m = exit_from_behind_goal(context_.field, robot.position_m)) {
      command = drive_to(robot, {*path_m, robot.heading}, robots_, driving_);
    } else if (role == Role::kKeeper) {
      command = keep(i, assignment);
    } else if (role == Role::kAttacker && may_play_ball()) {
      command = attack(assignment);
    } else {
      Waypoint waypoint = waypoint_of(i, assignment);
      waypoint.position_m = allowed(waypoint.position_m, now_.ball.position_m, limits_for(false));
      command = drive_to(robot, waypoint, robots_and_ball_, driving_);
    }
  }
}

// Positions, a different one for each robot, that depend only on the ball's position, so that all
// robots come to rest and play can continue.
Waypoint Basic::formation_of(int index) const {
  const Field& field = context_.field;
  const bool alone = now_.own.size() == 1;
  const int role = alone ? 1 : index;
  if (role == 0) return keeper_position(field, style_, {ball_target_m_, Vec2(0, 0), 0});
  if (role == 1) {
    const Vec2 back = direction_of(field.goal_centre_m(Side::kWest) - ball_target_m_, Vec2(-1, 0));
    const Vec2 position_m =
        ball_target_m_ + back * (context_.rules.opponents_to_ball_m + 2 * kRobotRadius_m);
    return {position_m, direction_of(ball_target_m_ - position_m, Vec2(1, 0))};
  }
  if (role == 2) return wall_position(field, style_, ball_target_m_, 0);
  if (role == 3) return supporter_position(field, style_, ball_target_m_, 0);
  return reserve_position(field, ball_target_m_, role - 4);
}

// The permitted position nearest to `wanted_m`. If the ball is so close to the team's own area that
// no robot fits between them, and the rule book requires a distance at restarts, the robot steps
// aside from the straight path to the goal.
Vec2 Basic::allowed(const Vec2& wanted_m, const Vec2& ball_m, const Limits& limits) const {
  const Field& field = context_.field;
  Vec2 position_m = permitted(field, wanted_m, ball_m, limits);
  if (!context_.rules.has(RuleId::kDefenderTooCloseToKickPoint)) return position_m;
  const Vec2 to_goal = field.goal_centre_m(Side::kWest) - ball_m;
  for (int i = 0; i < kSidesteps && (position_m - ball_m).norm() < limits.keep_from_ball_m; ++i) {
    const double side = cross(to_goal, position_m - ball_m) < 0 ? -1.0 : 1.0;
    const Vec2 aside = left_of(direction_of(to_goal, Vec2(-1, 0))) * side;
    position_m = permitted(field, position_m + aside * style_.sidestep_m, ball_m, limits);
  }
  return position_m;
}

// The position to which a robot that is too close to the ball during a stop drives first; nullopt
// if the robot is far enough away, or if the rule book does not require a distance.
std::optional<Vec2> Basic::position_off_ball(const Vec2& from_m) const {
  const double keep_m = room_at_ball_m() + kRobotRadius_m + 10_mm;
  const Vec2 off_m = from_m - ball_target_m_;
  if (!context_.rules.has(RuleId::kStopDistance) || off_m.norm() > keep_m) return std::nullopt;
  const Vec2 back =
      direction_of(context_.field.goal_centre_m(Side::kWest) - ball_target_m_, Vec2(-1, 0));
  return ball_target_m_ + direction_of(off_m, back) * (keep_m + kRobotRadius_m);
}

DrivingStyle Basic::waiting_style() const {
  DrivingStyle style = driving_;
  if (now_.play == Play::kStop && context_.rules.has(RuleId::kBotTooFastInStop)) {
    style.speed_mps = style_.stop_speed_share * context_.rules.stop_speed_mps;
  }
  return style;
}

void Basic::line_up(TeamCommands& commands) {
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    Waypoint waypoint = formation_of(i);
    const bool is_keeper = i == 0 && now_.own.size() > 1;
    waypoint.position_m = allowed(waypoint.position_m, ball_target_m_, limits_for(is_keeper));
    const TrackedRobot& robot = now_.own[i];
    if (const auto path_m = exit_from_behind_goal(context_.field, robot.position_m)) {
      waypoint.position_m = *path_m;
    } else if (const auto off_m = position_off_ball(robot.position_m); off_m && !is_keeper) {
      waypoint.position_m = *off_m;
    }
    commands[robot.number] =
        drive_to(robot, waypoint, is_keeper ? robots_ : robots_and_ball_, waiting_style());
  }
}

// Until the ball is in play, only the kicker and the keeper matter; the other robots wait behind
// the ball.
void Basic::stand_at_penalty(TeamCommands& commands) {
  const int kicker = now_.ours ? penalty_kicker(now_, ball_target_m_) : -1;
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    const TrackedRobot& robot = now_.own[i];
    if (i == kicker && now_.play == Play::kPenalty) {
      commands[robot.number] = play_ball(robot, now_.ball, now_.ball.position_m,
                                         attack_intent(robot), robots_, driving_);
      continue;
    }
    const Waypoint waypoint =
        i == kicker ? penalty_run_up(ball_target_m_)
        : i == 0    ? penalty_keeper(context_.field, ball_target_m_)
                    : penalty_spectator(context_.field, ball_target_m_,
                                        context_.rules.penalty_clearance_m, now_.ours, i - 1);
    commands[robot.number] =
        drive_to(robot, waypoint, i == 0 ? robots_ : robots_and_ball_, driving_);
  }
}

void Basic::decide(const TeamView& view, TeamCommands& commands) {
  look_ahead_.look(view, now_);
  if (view.play != Play::kHalt) command_robots(view, commands);
  look_ahead_.note(view.frame, commands);
}

void Basic::command_robots(const TeamView& view, TeamCommands& commands) {
  find_obstacles();
  if (!now_.own.empty()) requests_.keeper = now_.own.front().number;
  ball_target_m_ = now_.placement_m.value_or(now_.ball.position_m);
  const bool waiting = view.play == Play::kStop || view.play == Play::kPrepareKickoff;
  if (view.play == Play::kPreparePenalty || view.play == Play::kPenalty) {
    stand_at_penalty(commands);
  } else if (waiting) {
    line_up(commands);
  } else {
    play(commands);
  }
  avoid_contact(commands);
}

}  // namespace autoref::strategies::basic
