#include "strategies/basic/basic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "strategies/skills/outlook.hpp"
#include "strategies/skills/shot.hpp"
#include "strategies/tactics/penalty.hpp"

namespace autoref::strategies::basic {
namespace {

constexpr double kRobotClearance_m = 2 * kRobotRadius_m + 30_mm;
constexpr double kDuel_m = 250_mm;      // an opponent this near to the ball presses
constexpr double kPassLane_m = 200_mm;  // a pass wants this much room
constexpr double kShotLane_m = 110_mm;  // a shot wants a robot's and a ball's radius
constexpr double kFreeLane_m = 300_mm;  // more room than this does not help
constexpr double kSlowestPass_mps = 1.3;
constexpr double kPassPerMetre_per_s = 0.7;  // further passes are kicked harder
constexpr double kBackPass_m = 200_mm;       // passes go no farther back than this
constexpr double kPush_mps = 1.6;            // a kick ahead where nothing better is open
constexpr double kClearance_mps = 3.0;       // the keeper's kick away from the goal
constexpr double kFromTheirArea_m = 100_mm;  // a nearer ball is left alone where a rule asks for it
constexpr int kSidesteps = 12;               // at most, from the ball's way to the goal
constexpr double kSidestep_m = 60_mm;
constexpr double kStopSpeedShare = 0.8;  // of the speed allowed while play is stopped
constexpr double kSlowBall_mps = 1.5;    // the keeper comes out for balls slower than this

constexpr std::array<Parameter, 2> kParameters = {{
    {"shot_mps", "m/s", 6.5, 0, 8, "Speed of shots at the goal."},
    {"pass_mps", "m/s", 4.0, 0, 8, "Speed of passes, at most."},
}};

// Where faster kicks are fouls, kicks stay below the limit although kickers are off by a few
// hundredths.
double fastest_kick_mps(const RuleBook& rules) {
  constexpr double kCaution = 0.93;
  return rules.kick_limit_mps * (rules.has(RuleId::kKickSpeed) ? kCaution : 1.0);
}

}  // namespace

std::span<const Parameter> parameters() { return kParameters; }

Basic::Basic(const Briefing& briefing)
    : briefing_(briefing),
      shot_mps_(
          std::min(value_of(kParameters[0], briefing.params), fastest_kick_mps(briefing.rules))),
      pass_mps_(
          std::min(value_of(kParameters[1], briefing.params), fastest_kick_mps(briefing.rules))) {}

// From a hull to the ball's centre at restarts. Referees who judge it measure to the ball's
// surface.
double Basic::room_at_ball_m() const {
  const bool is_judged = briefing_.rules.has(RuleId::kRestartDistance);
  return briefing_.rules.opponents_to_ball_m + (is_judged ? kBallRadius_m : 0.0);
}

Limits Basic::limits_for(bool is_keeper) const {
  Limits limits;
  limits.may_enter_own_area = is_keeper;
  limits.may_stay_behind_goal = true;
  if (now_.play == Play::kRunning) return limits;
  limits.own_half_only = now_.play == Play::kPrepareKickoff || now_.play == Play::kKickoff;
  const bool may_come_near = now_.ours && is_restart(now_.play);
  limits.keep_from_ball_m = may_come_near ? 0 : room_at_ball_m() + kRobotRadius_m;
  limits.keep_from_area_m = briefing_.rules.attacker_to_area_m + kRobotRadius_m;
  return limits;
}

Obstacles Basic::obstacles_for(int index, bool avoid_ball) const {
  Obstacles obstacles;
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    if (i != index) obstacles.push_back({now_.own[i].position_m, kRobotClearance_m});
  }
  for (const TrackedRobot& opponent : now_.opponents) {
    obstacles.push_back({opponent.position_m, kRobotClearance_m});
  }
  if (avoid_ball) {
    const double room_m = now_.play == Play::kRunning ? 20_mm : room_at_ball_m();
    obstacles.push_back({now_.ball.position_m, kRobotRadius_m + room_m});
  }
  return obstacles;
}

Waypoint Basic::waypoint_of(int index, const Cast& cast) const {
  const Part& part = cast.parts[index];
  switch (part.role) {
    case Role::kKeeper:
      return keeper_position(briefing_.field, now_.ball);
    case Role::kAttacker:
    case Role::kWall:
      return wall_position(briefing_.field, ball_place_m_, part.order);
    case Role::kSupporter:
      return supporter_position(briefing_.field, ball_place_m_, part.order);
    case Role::kMarker:
      return marker_position(briefing_.field, now_.opponents[part.marks], ball_place_m_);
  }
  return {};
}

bool Basic::is_pressed() const {
  return std::any_of(now_.opponents.begin(), now_.opponents.end(), [&](const TrackedRobot& o) {
    return (o.position_m - now_.ball.position_m).norm() < kDuel_m;
  });
}

// A pass that arrives at a speed that a robot can take.
double Basic::pass_speed_mps(double distance_m) const {
  return std::min(pass_mps_, kSlowestPass_mps + kPassPerMetre_per_s * distance_m);
}

// The team-mate whom a pass reaches most safely, not behind the ball; or none.
std::optional<Aim> Basic::best_pass(int passer) const {
  std::optional<Aim> best;
  for (const TrackedRobot& mate : now_.own) {
    if (mate.number == passer || mate.position_m.x() < now_.ball.position_m.x() - kBackPass_m) {
      continue;
    }
    const double lane_m = lane_clearance_m(now_.ball.position_m, mate.position_m, now_.opponents);
    if (lane_m > (best ? best->clearance_m : kPassLane_m)) best = Aim{mate.position_m, lane_m};
  }
  return best;
}

// A shot where the goal is open, else a pass, else a push towards the goal that stays in play.
Intent Basic::attack_intent(const TrackedRobot& attacker) const {
  const Vec2& ball_m = now_.ball.position_m;
  TrackedRobots others = now_.opponents;  // mates in the way stop a shot as well
  for (const TrackedRobot& mate : now_.own) {
    if (mate.number != attacker.number && others.size() < others.capacity()) others.push_back(mate);
  }
  Aim aim = best_shot(briefing_.field, ball_m, others);
  double kick_mps = shot_mps_;
  if (aim.clearance_m < kShotLane_m) {
    const std::optional<Aim> pass = best_pass(attacker.number);
    kick_mps = pass ? pass_speed_mps((pass->target_m - ball_m).norm()) : kPush_mps;
    aim = pass ? *pass : best_push(briefing_.field, ball_m, now_.opponents);
  }
  Intent intent{aim.target_m, kick_mps};
  const double distance_m = std::max(0.1, (aim.target_m - ball_m).norm());
  intent.tolerance_rad =
      std::clamp(0.5 * std::min(aim.clearance_m, kFreeLane_m) / distance_m, 0.04, 0.2);
  if (is_pressed() && now_.play == Play::kRunning) intent.hasty_mps = kPush_mps;
  return intent;
}

RobotCommand Basic::attack(const Cast& cast) const {
  const TrackedRobot& robot = now_.own[cast.attacker];
  const Obstacles obstacles = obstacles_for(cast.attacker, false);
  if (now_.play == Play::kRunning && comes_at(robot, now_.ball)) {
    return receive_ball(robot, now_.ball, cast.meeting.point_m, obstacles, style_);
  }
  return play_ball(robot, now_.ball, cast.meeting.point_m, attack_intent(robot), obstacles, style_);
}

RobotCommand Basic::keep(int index, const Cast& cast) const {
  const TrackedRobot& robot = now_.own[index];
  const Vec2& ball_m = now_.ball.position_m;
  const bool ball_in_area = distance_to_defence_area(briefing_.field, Side::kWest, ball_m) < 0.05 &&
                            ball_m.x() > -briefing_.field.half_length_m();
  if (ball_in_area && now_.play == Play::kRunning &&
      now_.ball.velocity_mps.norm() < kSlowBall_mps) {
    const Vec2 away_m =
        ball_m + direction_of(ball_m - briefing_.field.goal_centre_m(Side::kWest), Vec2(1, 0));
    return play_ball(robot, now_.ball, intercept(robot, now_.ball).point_m,
                     {away_m, kClearance_mps, 0.5}, obstacles_for(index, false), style_);
  }
  return drive_to(robot, waypoint_of(index, cast), {}, style_);
}

// Whether the attacker may go for the ball now, and can without breaking a rule.
bool Basic::may_play_ball() const {
  if (now_.play != Play::kRunning) return now_.ours && is_restart(now_.play);
  const double to_area_m =
      distance_to_defence_area(briefing_.field, Side::kWest, now_.ball.position_m);
  const bool is_theirs = briefing_.rules.has(RuleId::kAttackerInArea) &&
                         distance_to_defence_area(briefing_.field, Side::kEast,
                                                  now_.ball.position_m) < kFromTheirArea_m;
  return !is_theirs && (now_.own.size() == 1 || to_area_m > kFrontDistance_m);
}

void Basic::play(TeamOrders& orders) {
  const Cast cast = cast_parts(now_, briefing_.field, former_attacker_);
  former_attacker_ = cast.attacker < 0 ? -1 : now_.own[cast.attacker].number;
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    const TrackedRobot& robot = now_.own[i];
    RobotCommand& order = orders[robot.number];
    const Role role = cast.parts[i].role;
    if (const auto way_m = way_from_behind_goal(briefing_.field, robot.position_m)) {
      order = drive_to(robot, {*way_m, robot.heading}, obstacles_for(i, false), style_);
    } else if (role == Role::kKeeper) {
      order = keep(i, cast);
    } else if (role == Role::kAttacker && may_play_ball()) {
      order = attack(cast);
    } else {
      Waypoint place = waypoint_of(i, cast);
      place.position_m = allowed(place.position_m, now_.ball.position_m, limits_for(false));
      order = drive_to(robot, place, obstacles_for(i, true), style_);
    }
  }
}

// A place for each robot that depends on nothing but the ball's place, so that everybody comes to
// rest and play can go on.
Waypoint Basic::formation_of(int index) const {
  const Field& field = briefing_.field;
  const bool alone = now_.own.size() == 1;
  const int part = alone ? 1 : index;
  if (part == 0) return keeper_position(field, {ball_place_m_, Vec2(0, 0), 0});
  if (part == 1) {
    const Vec2 back = direction_of(field.goal_centre_m(Side::kWest) - ball_place_m_, Vec2(-1, 0));
    const Vec2 place_m =
        ball_place_m_ + back * (briefing_.rules.opponents_to_ball_m + 2 * kRobotRadius_m);
    return {place_m, direction_of(ball_place_m_ - place_m, Vec2(1, 0))};
  }
  if (part == 2) return wall_position(field, ball_place_m_, 0);
  if (part == 3) return supporter_position(field, ball_place_m_, 0);
  return reserve_position(field, ball_place_m_, part - 4);
}

// The permitted place. Where the ball lies so near to the own area that nobody fits between, the
// books that ask for the distance at restarts get it beside the straight way to the goal.
Vec2 Basic::allowed(const Vec2& wanted_m, const Vec2& ball_m, const Limits& limits) const {
  const Field& field = briefing_.field;
  Vec2 place_m = permitted(field, wanted_m, ball_m, limits);
  if (!briefing_.rules.has(RuleId::kRestartDistance)) return place_m;
  const Vec2 to_goal = field.goal_centre_m(Side::kWest) - ball_m;
  for (int i = 0; i < kSidesteps && (place_m - ball_m).norm() < limits.keep_from_ball_m; ++i) {
    const double side = cross(to_goal, place_m - ball_m) < 0 ? -1.0 : 1.0;
    const Vec2 aside = left_of(direction_of(to_goal, Vec2(-1, 0))) * side;
    place_m = permitted(field, place_m + aside * kSidestep_m, ball_m, limits);
  }
  return place_m;
}

// Where a robot goes first that is too near to the ball in a stop, by books that forbid it.
std::optional<Vec2> Basic::way_off_ball(const Vec2& from_m) const {
  const double keep_m = room_at_ball_m() + kRobotRadius_m + 10_mm;
  const Vec2 off_m = from_m - ball_place_m_;
  if (!briefing_.rules.has(RuleId::kStopDistance) || off_m.norm() > keep_m) return std::nullopt;
  const Vec2 back =
      direction_of(briefing_.field.goal_centre_m(Side::kWest) - ball_place_m_, Vec2(-1, 0));
  return ball_place_m_ + direction_of(off_m, back) * (keep_m + kRobotRadius_m);
}

DrivingStyle Basic::waiting_style() const {
  DrivingStyle style = style_;
  if (now_.play == Play::kStop && briefing_.rules.has(RuleId::kStopSpeed)) {
    style.speed_mps = kStopSpeedShare * briefing_.rules.stop_speed_mps;
  }
  return style;
}

void Basic::line_up(TeamOrders& orders) {
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    Waypoint place = formation_of(i);
    const bool is_keeper = i == 0 && now_.own.size() > 1;
    place.position_m = allowed(place.position_m, ball_place_m_, limits_for(is_keeper));
    const TrackedRobot& robot = now_.own[i];
    if (const auto way_m = way_from_behind_goal(briefing_.field, robot.position_m)) {
      place.position_m = *way_m;
    } else if (const auto off_m = way_off_ball(robot.position_m); off_m && !is_keeper) {
      place.position_m = *off_m;
    }
    orders[robot.number] = drive_to(robot, place, obstacles_for(i, !is_keeper), waiting_style());
  }
}

// Until the ball is in play only kicker and keeper count; the others wait behind it.
void Basic::stand_at_penalty(TeamOrders& orders) {
  const int kicker = now_.ours ? penalty_kicker(now_, ball_place_m_) : -1;
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    const TrackedRobot& robot = now_.own[i];
    if (i == kicker && now_.play == Play::kPenalty) {
      orders[robot.number] = play_ball(robot, now_.ball, now_.ball.position_m, attack_intent(robot),
                                       obstacles_for(i, false), style_);
      continue;
    }
    const Waypoint place =
        i == kicker ? penalty_run_up(ball_place_m_)
        : i == 0    ? penalty_keeper(briefing_.field, ball_place_m_)
                    : penalty_spectator(briefing_.field, ball_place_m_,
                                        briefing_.rules.penalty_clearance_m, now_.ours, i - 1);
    orders[robot.number] = drive_to(robot, place, obstacles_for(i, i != 0), style_);
  }
}

void Basic::decide(const TeamView& view, TeamOrders& orders) {
  if (view.play == Play::kHalt) return;
  look_ahead(view, now_);
  if (!now_.own.empty()) requests_.keeper = now_.own.front().number;
  ball_place_m_ = now_.placement_m.value_or(now_.ball.position_m);
  const bool waiting = view.play == Play::kStop || view.play == Play::kPrepareKickoff;
  if (view.play == Play::kPreparePenalty || view.play == Play::kPenalty) {
    stand_at_penalty(orders);
  } else if (waiting) {
    line_up(orders);
  } else {
    play(orders);
  }
}

}  // namespace autoref::strategies::basic
