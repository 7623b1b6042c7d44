#include "strategies/basic/basic.hpp"

#include <algorithm>
#include <cmath>

#include "strategies/skills/outlook.hpp"
#include "strategies/skills/shot.hpp"

namespace autoref::strategies::basic {
namespace {

constexpr double kRobotClearance_m = 2 * kRobotRadius_m + 30_mm;
constexpr double kDuel_m = 250_mm;          // an opponent this near to the ball presses
constexpr double kDuelTolerance_rad = 0.7;  // and one kicks with less care
constexpr double kPassLane_m = 200_mm;      // a pass wants this much room
constexpr double kShotLane_m = 110_mm;      // a shot wants a robot's and a ball's radius
constexpr double kClearance_mps = 5.0;      // the keeper's kick away from the goal
constexpr double kSlowBall_mps = 1.5;       // the keeper comes out for balls slower than this

double param(const Setup& setup, const char* name, double otherwise) {
  const auto found = setup.params.find(name);
  return found == setup.params.end() ? otherwise : found->second;
}

}  // namespace

Basic::Basic(const Setup& setup)
    : setup_(setup),
      shot_mps_(std::min(param(setup, "shot_mps", 6.5), setup.rules.kick_limit_mps)),
      pass_mps_(std::min(param(setup, "pass_mps", 4.0), setup.rules.kick_limit_mps)) {}

Limits Basic::limits_for(bool is_keeper) const {
  Limits limits;
  limits.may_enter_own_area = is_keeper;
  if (now_.play == Play::kRunning) return limits;
  limits.own_half_only = now_.play == Play::kPrepareKickoff || now_.play == Play::kKickoff;
  const bool may_come_near = now_.ours && is_restart(now_.play);
  limits.keep_from_ball_m = may_come_near ? 0 : setup_.rules.opponents_to_ball_m + kRobotRadius_m;
  limits.keep_from_area_m = setup_.rules.attacker_to_area_m + kRobotRadius_m;
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
    const double room_m = now_.play == Play::kRunning ? 20_mm : setup_.rules.opponents_to_ball_m;
    obstacles.push_back({now_.ball.position_m, kRobotRadius_m + room_m});
  }
  return obstacles;
}

Waypoint Basic::waypoint_of(int index, const Cast& cast) const {
  const Part& part = cast.parts[index];
  switch (part.role) {
    case Role::kKeeper:
      return keeper_position(setup_.field, now_.ball);
    case Role::kAttacker:
    case Role::kWall:
      return wall_position(setup_.field, ball_place_m_);
    case Role::kSupporter:
      return supporter_position(setup_.field, ball_place_m_);
    case Role::kMarker:
      return marker_position(setup_.field, now_.opponents[part.marks], ball_place_m_);
    case Role::kReserve:
      return reserve_position(setup_.field, ball_place_m_, part.order);
  }
  return {};
}

Intent Basic::attack_intent(const TrackedRobot& attacker) const {
  const Vec2& ball_m = now_.ball.position_m;
  const Aim shot = best_shot(setup_.field, ball_m, now_.opponents);
  Intent intent{shot.target_m, shot_mps_, 0};
  double room_m = std::max(shot.clearance_m, kShotLane_m);
  if (shot.clearance_m < kShotLane_m) {
    for (const TrackedRobot& mate : now_.own) {
      const double lane_m = lane_clearance_m(ball_m, mate.position_m, now_.opponents);
      const bool ahead = mate.position_m.x() > ball_m.x() - 0.2;
      if (mate.number == attacker.number || !ahead || lane_m < std::max(room_m, kPassLane_m)) {
        continue;
      }
      room_m = lane_m;
      intent = {mate.position_m, pass_mps_, 0};
    }
  }
  const double distance_m = std::max(0.1, (intent.target_m - ball_m).norm());
  intent.tolerance_rad = std::clamp(0.5 * std::min(room_m, 0.3) / distance_m, 0.04, 0.2);
  const bool pressed =
      std::any_of(now_.opponents.begin(), now_.opponents.end(),
                  [&](const TrackedRobot& o) { return (o.position_m - ball_m).norm() < kDuel_m; });
  if (pressed && !is_restart(now_.play)) intent.tolerance_rad = kDuelTolerance_rad;
  return intent;
}

RobotCommand Basic::attack(const Cast& cast) const {
  const TrackedRobot& robot = now_.own[cast.attacker];
  return play_ball(robot, now_.ball, cast.meeting.point_m, attack_intent(robot),
                   obstacles_for(cast.attacker, false), style_);
}

RobotCommand Basic::keep(int index, const Cast& cast) const {
  const TrackedRobot& robot = now_.own[index];
  const Vec2& ball_m = now_.ball.position_m;
  const bool ball_in_area = distance_to_defence_area(setup_.field, Side::kWest, ball_m) < 0.05 &&
                            ball_m.x() > -setup_.field.half_length_m();
  if (ball_in_area && now_.play == Play::kRunning &&
      now_.ball.velocity_mps.norm() < kSlowBall_mps) {
    const Vec2 away_m =
        ball_m + direction_of(ball_m - setup_.field.goal_centre_m(Side::kWest), Vec2(1, 0));
    return play_ball(robot, now_.ball, intercept(robot, now_.ball).point_m,
                     {away_m, kClearance_mps, 0.5}, obstacles_for(index, false), style_);
  }
  return drive_to(robot, waypoint_of(index, cast), {}, style_);
}

// Whether the attacker may go for the ball now, and can without breaking a rule.
bool Basic::may_play_ball() const {
  if (now_.play != Play::kRunning) return now_.ours && is_restart(now_.play);
  const double to_area_m =
      distance_to_defence_area(setup_.field, Side::kWest, now_.ball.position_m);
  return now_.own.size() == 1 || to_area_m > kFrontDistance_m;
}

void Basic::play(TeamOrders& orders) {
  const Cast cast = cast_parts(now_, setup_.field, former_attacker_);
  former_attacker_ = cast.attacker < 0 ? -1 : now_.own[cast.attacker].number;
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    const TrackedRobot& robot = now_.own[i];
    RobotCommand& order = orders[robot.number];
    const Role role = cast.parts[i].role;
    if (role == Role::kKeeper) {
      order = keep(i, cast);
    } else if (role == Role::kAttacker && may_play_ball()) {
      order = attack(cast);
    } else {
      Waypoint place = waypoint_of(i, cast);
      place.position_m =
          permitted(setup_.field, place.position_m, now_.ball.position_m, limits_for(false));
      order = drive_to(robot, place, obstacles_for(i, true), style_);
    }
  }
}

// A place for each robot that depends on nothing but the ball's place, so that everybody comes to
// rest and play can go on.
Waypoint Basic::formation_of(int index) const {
  const Field& field = setup_.field;
  const bool alone = now_.own.size() == 1;
  const int part = alone ? 1 : index;
  if (part == 0) return keeper_position(field, {ball_place_m_, Vec2(0, 0), 0});
  if (part == 1) {
    const Vec2 back = direction_of(field.goal_centre_m(Side::kWest) - ball_place_m_, Vec2(-1, 0));
    const Vec2 place_m =
        ball_place_m_ + back * (setup_.rules.opponents_to_ball_m + 2 * kRobotRadius_m);
    return {place_m, direction_of(ball_place_m_ - place_m, Vec2(1, 0))};
  }
  if (part == 2) return wall_position(field, ball_place_m_);
  if (part == 3) return supporter_position(field, ball_place_m_);
  return reserve_position(field, ball_place_m_, part - 4);
}

void Basic::line_up(TeamOrders& orders) {
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    Waypoint place = formation_of(i);
    const bool is_keeper = i == 0 && now_.own.size() > 1;
    place.position_m =
        permitted(setup_.field, place.position_m, ball_place_m_, limits_for(is_keeper));
    const TrackedRobot& robot = now_.own[i];
    orders[robot.number] = drive_to(robot, place, obstacles_for(i, !is_keeper), style_);
  }
}

void Basic::decide(const TeamView& view, TeamOrders& orders) {
  if (view.play == Play::kHalt) return;
  look_ahead(view, now_);
  ball_place_m_ = now_.placement_m.value_or(now_.ball.position_m);
  const bool waiting = view.play == Play::kStop || view.play == Play::kPrepareKickoff ||
                       view.play == Play::kPreparePenalty;
  if (waiting) {
    line_up(orders);
  } else {
    play(orders);
  }
}

}  // namespace autoref::strategies::basic
