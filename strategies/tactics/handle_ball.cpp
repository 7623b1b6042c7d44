#include "strategies/tactics/handle_ball.hpp"

#include <algorithm>
#include <cmath>

#include "strategies/tactics/pass_field.hpp"

namespace autoref::strategies {
namespace {

// Out of the field where a push that way would bring the ball over the line, else zero.
Vec2 out_of_field(const Field& field, const Vec2& ball_m, double near_line_m) {
  if (std::abs(ball_m.y()) > field.half_width_m() - near_line_m)
    return {0, std::copysign(1.0, ball_m.y())};
  if (std::abs(ball_m.x()) > field.half_length_m() - near_line_m)
    return {std::copysign(1.0, ball_m.x()), 0};
  return {0, 0};
}

}  // namespace

BallHandler::BallHandler(const Outlook& outlook) : outlook_(outlook), face_off_(outlook) {}

// One mate's place is valued anew in each frame.
void BallHandler::update() {
  const TeamView& now = outlook_.now();
  if (now.own.empty()) return;
  const auto turn = static_cast<std::size_t>(now.frame) % now.own.size();
  const TrackedRobot& mate = now.own[turn];
  chances_[static_cast<std::size_t>(mate.number)] =
      chance_at(outlook_, mate.position_m, mate.number);
  if (receiver_ && now.time_s > receiver_until_s_) receiver_.reset();
  if (now.play != Play::kRunning && !is_restart(now.play)) receiver_.reset();
}

// An open goal is shot at; else the best of what can be done, with less turning under pressure.
Choice BallHandler::choose(int index, const Vec2& from_m) const {
  const TrackedRobot& robot = outlook_.robot(index);
  const double pressure = pressure_at(outlook_, from_m);
  const auto less_turning = [&](Choice option) {
    const Vec2 aim = direction_of(option.strike.target_m - from_m, robot.heading);
    option.worth -= outlook_.style().turn_cost * pressure * (1 - robot.heading.dot(aim)) / 2;
    return option;
  };
  Choice best = shot_from(outlook_, robot.number, from_m);
  const bool is_shooting = choice_.kind == Choice::Kind::kShot;
  if (best.worth >=
      outlook_.style().shot_threshold * (is_shooting ? outlook_.style().still_shoots : 1.0))
    return best;
  best = less_turning(best);
  const auto consider = [&](Choice option) {
    if (option.kind == choice_.kind && option.receiver == choice_.receiver)
      option.worth += outlook_.style().choice_loyalty;
    option = less_turning(option);
    if (option.worth > best.worth) best = option;
  };
  for (int mate = 0; mate < outlook_.robots(); ++mate) {
    const bool is_keeper = mate == 0 && outlook_.robots() > 3;
    if (mate == index || is_keeper) continue;
    const double chance = chances_[static_cast<std::size_t>(outlook_.robot(mate).number)];
    const Choice pass = pass_to(outlook_, mate, chance, from_m);
    consider(pass);
    if (pass.worth < outlook_.style().worthless) consider(chip_to(outlook_, mate, chance, from_m));
  }
  if (outlook_.now().play == Play::kRunning && !must_release())
    consider(carry_from(outlook_, from_m));
  if (best.worth >= outlook_.style().worthless) return best;
  consider(clear_from(outlook_, from_m, robot.heading));
  if (best.kind == Choice::Kind::kClear && pressure > outlook_.style().pressed)
    best.strike.tolerance_rad = outlook_.style().rough_clear_rad;
  return best;
}

RobotCommand BallHandler::carry(int index) const {
  const TrackedRobot& robot = outlook_.robot(index);
  const Vec2& goal_m = outlook_.field().goal_centre_m(Side::kEast);
  Vec2 way = direction_of(goal_m - robot.position_m, Vec2(1, 0));
  for (const TrackedRobot& opponent : outlook_.now().opponents) {
    const Vec2 off = robot.position_m - opponent.position_m;
    const double distance_m = off.norm();
    if (distance_m < outlook_.style().shy_m && distance_m > 1e-6)
      way += off / distance_m * (outlook_.style().shy_m - distance_m) * outlook_.style().shyness;
  }
  const Vec2 edge_m(outlook_.field().half_length_m(), outlook_.field().half_width_m());
  for (int axis = 0; axis < 2; ++axis) {
    const double near = std::abs(robot.position_m[axis]) - (edge_m[axis] - outlook_.style().edge_m);
    if (near > 0)
      way[axis] -= std::copysign(near / outlook_.style().edge_m * outlook_.style().edge_shyness,
                                 robot.position_m[axis]);
  }
  const Vec2 heading = direction_of(way, Vec2(1, 0));
  const double along = std::max(0.0, robot.heading.dot(heading));
  return carry_ball(robot, heading * (outlook_.style().carry_mps * along), heading);
}

void BallHandler::note_hold(const TrackedRobot& robot, bool holds) {
  if (!holds || holder_ != robot.number) taken_from_m_ = outlook_.path().now_m();
  holder_ = holds ? robot.number : -1;
}

RobotCommand BallHandler::play(int index) {
  const TrackedRobot& robot = outlook_.robot(index);
  const Vec2& ball_m = outlook_.path().now_m();
  const Meeting& meeting = outlook_.meeting(index);
  const bool holds = has_ball(robot, ball_m);
  choice_ = choose(index, holds ? ball_m : meeting.point_m);
  const bool hurried = outlook_.theirs().time_s < meeting.time_s + outlook_.style().hurry_s;
  choice_.strike.bend_rad =
      hurried ? outlook_.style().pressed_bend_rad : outlook_.style().free_bend_rad;
  note_hold(robot, holds);
  if (outlook_.now().play == Play::kRunning && opponent_has_ball(outlook_) && !must_release())
    return holds ? face_off_.break_away(outlook_.now().time_s) : block_ball(outlook_, index);
  if (holds && choice_.kind == Choice::Kind::kCarry) return carry(index);
  RobotCommand command = strike(index);
  const bool is_pass = choice_.kind == Choice::Kind::kPass || choice_.kind == Choice::Kind::kChip;
  if (command.kick_mps > 0 && is_pass) {
    receiver_ = choice_.receiver;
    receiver_until_s_ = outlook_.now().time_s + outlook_.style().pass_flight_s;
  }
  return command;
}

RobotCommand BallHandler::strike(int index) const {
  const TrackedRobot& robot = outlook_.robot(index);
  const BallPath& path = outlook_.path();
  const Meeting& meeting = outlook_.meeting(index);
  Obstacles obstacles;
  // Close to the ball it fights for it instead of going round whoever is there as well.
  if ((meeting.point_m - robot.position_m).norm() > outlook_.style().fight_m)
    robots_around(outlook_, index, meeting.point_m, obstacles);
  const DrivingStyle style = outlook_.driving(index);
  if (outlook_.now().play != Play::kRunning)
    return take_kick(robot, path.now_m(), choice_.strike, obstacles, style);
  Strike now = choice_.strike;
  now.keep_off = out_of_field(outlook_.field(), path.now_m(), outlook_.style().near_line_m);
  if (must_release()) now.tolerance_rad = outlook_.style().release_rad;
  return strike_ball(robot, path, meeting, now, obstacles, style);
}

// Whether the ball has been taken nearly as far as dribbling is allowed.
bool BallHandler::must_release() const {
  if (!outlook_.rules().has(RuleId::kDribbling)) return false;
  const double way_m = (outlook_.path().now_m() - taken_from_m_).norm();
  return way_m > outlook_.style().dribbling_share * outlook_.rules().dribbling_m;
}

}  // namespace autoref::strategies
