#include "strategies/tactics/handle_ball.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "strategies/tactics/areas.hpp"
#include "strategies/tactics/pass_field.hpp"

namespace autoref::strategies {
namespace {

constexpr double kTouches_m = 5_mm;  // largest gap to a ball in contact
constexpr double kBackwards = -0.3;  // x of a heading below which a kick goes backwards
constexpr double kLetGo_mps = 1.5;
constexpr double kCommitted_m = 125_mm;  // distance from the taker's centre to the ball
constexpr double kMoves_mps = 0.3;       // a ball faster than this is moving
constexpr double kLong_s = 10;           // practically unlimited time

// A unit vector out of the field if the ball is so close to a line that a push could move it out;
// otherwise zero.
Vec2 out_of_field(const Field& field, const Vec2& ball_m, double near_line_m) {
  if (std::abs(ball_m.y()) > field.half_width_m() - near_line_m)
    return {0, std::copysign(1.0, ball_m.y())};
  if (std::abs(ball_m.x()) > field.half_length_m() - near_line_m)
    return {std::copysign(1.0, ball_m.x()), 0};
  return {0, 0};
}

// Reduces a velocity towards the opponents' area so that the ball can stop before it.
Vec2 slowed_with_ball(const PredictedState& predicted, const Vec2& ball_m,
                      const Vec2& velocity_mps) {
  if (!predicted.rules().has(RuleId::kAttackerTouchedBallInDefenseArea)) return velocity_mps;
  const double room_m = distance_to_defence_area(predicted.field(), Side::kEast, ball_m) -
                        predicted.style().from_their_area_m;
  return slowed_before_area(predicted, Side::kEast, ball_m, room_m, velocity_mps);
}

Strike with_turning(Strike strike, const Style& style) {
  strike.turn_radps = style.ball_turn_radps;
  strike.turn_braking_radps2 = style.ball_turn_braking_radps2;
  return strike;
}

}  // namespace

BallHandler::BallHandler(const PredictedState& predicted)
    : predicted_(predicted), face_off_(predicted) {}

// Only one team-mate's chance is updated per frame.
void BallHandler::update() {
  const TeamView& now = predicted_.now();
  if (now.own.empty()) return;
  note_contacts();
  const auto turn = static_cast<std::size_t>(now.frame) % now.own.size();
  const TrackedRobot& mate = now.own[turn];
  chances_[static_cast<std::size_t>(mate.number)] =
      chance_at(predicted_, mate.position_m, mate.number);
  if (receiver_ && now.time_s > receiver_until_s_) receiver_.reset();
  if (now.play != Play::kRunning && !is_restart(now.play)) receiver_.reset();
}

// Chooses a clear shot if there is one, otherwise the best option. Under pressure, options that
// need less turning are preferred.
Choice BallHandler::choose(int index, const Vec2& from_m) const {
  const TrackedRobot& robot = predicted_.robot(index);
  const double pressure = pressure_at(predicted_, from_m);
  // (1 - cosine) / 2 is 0 if the robot already faces the target, and 1 if it faces away.
  const auto less_turning = [&](Choice option) {
    const Vec2 aim = direction_of(option.strike.target_m - from_m, robot.heading);
    option.worth -= predicted_.style().turn_nll * pressure * (1 - robot.heading.dot(aim)) / 2;
    return option;
  };
  // Without team-mates, a robot always shoots, which gives it time to return to its goal.
  if (predicted_.robots() == 1 && !predicted_.now().opponents.empty())
    return shot_from(predicted_, robot.number, from_m);
  const std::optional<Hold> hold = hold_of(index, from_m);
  const auto in_time = [&](Choice option) {
    if (!hold || option.strike.kick_mps <= 0) return option;
    const Vec2 aim = direction_of(option.strike.target_m - from_m, robot.heading);
    const double chance = chance_to_turn(predicted_.style(), *hold, aim);
    option.worth -= (1 - chance) * (std::max(0.0, option.worth) + predicted_.style().late_cost);
    return option;
  };
  Choice best = may_score() ? in_time(shot_from(predicted_, robot.number, from_m)) : Choice{};
  const bool is_shooting = choice_.kind == Choice::Kind::kShot;
  if (best.worth >=
      predicted_.style().shot_threshold * (is_shooting ? predicted_.style().still_shoots : 1.0))
    return best;
  best = less_turning(best);
  // Having to turn can only lower the value, apart from rounding errors.
  constexpr double kTurnGain = 1e-9;
  const auto consider = [&](Choice option) {
    if (option.kind == choice_.kind && option.receiver == choice_.receiver)
      option.worth += predicted_.style().choice_loyalty;
    if (option.worth < best.worth - kTurnGain) return;
    option = in_time(less_turning(option));
    if (option.worth > best.worth) best = option;
  };
  for (int mate = 0; mate < predicted_.robots(); ++mate) {
    const bool is_keeper = mate == 0 && predicted_.robots() > 3;
    if (mate == index || is_keeper) continue;
    const double chance = chances_[static_cast<std::size_t>(predicted_.robot(mate).number)];
    const Choice pass = pass_to(predicted_, mate, chance, from_m);
    consider(pass);
    if (pass.worth < predicted_.style().clear_below)
      consider(chip_to(predicted_, mate, chance, from_m));
  }
  if (predicted_.now().play == Play::kRunning && !must_release())
    consider(carry_from(predicted_, from_m));
  if (may_dribble_restart()) consider(dribble_from(predicted_, from_m));
  if (best.worth >= predicted_.style().clear_below) return best;
  consider(clear_from(predicted_, from_m, robot.heading));
  if (best.kind == Choice::Kind::kClear && pressure > predicted_.style().pressed)
    best.strike.tolerance_rad = predicted_.style().rough_clear_rad;
  return best;
}

// How the robot holds the ball or will meet it: head-on if the ball comes towards it, otherwise
// from a side that needs little turning (strike_ball()). It is empty if the robot has enough time
// to turn.
std::optional<Hold> BallHandler::hold_of(int index, const Vec2& from_m) const {
  const Style& style = predicted_.style();
  if (style.late_cost <= 0 || predicted_.now().play != Play::kRunning) return std::nullopt;
  const TrackedRobot& robot = predicted_.robot(index);
  const BallPath& path = predicted_.path();
  const bool holds = has_ball(robot, path.now_m());
  const double own_s = holds ? 0.0 : predicted_.interception(index).time_s;
  const double alone_s = std::max(0.0, predicted_.theirs().time_s - own_s) + style.contested_hold_s;
  Hold hold{robot.heading, 0, std::min(alone_s, dribble_left_s(robot, holds))};
  if (holds) return hold;
  if (comes_towards(robot, path)) {
    hold.heading = -path.direction();
    hold.free_rad = kWideFirstTouch_rad;
    return hold;
  }
  hold.heading = direction_of(from_m - robot.position_m, robot.heading);
  hold.free_rad = is_hurried(index) ? style.pressed_bend_rad : style.free_bend_rad;
  return hold;
}

// How long the robot can turn with the ball before it has dribbled the ball nearly too far.
double BallHandler::dribble_left_s(const TrackedRobot& robot, bool holds) const {
  const Style& style = predicted_.style();
  if (!predicted_.rules().has(RuleId::kBotDribbledBallTooFar)) return kLong_s;
  double left_m = hasty_share() * predicted_.rules().dribbling_m;
  const auto& contact_m = contact_from_m_[static_cast<std::size_t>(robot.number)];
  if (holds) left_m -= dribbled_m(contact_m.value_or(taken_from_m_));
  return std::max(0.0, left_m) / style.turning_ball_mps;
}

// Potential field: the opponents' goal attracts, opponents and lines repel with a force that grows
// linearly as they get nearer.
RobotCommand BallHandler::carry(int index) const {
  const TrackedRobot& robot = predicted_.robot(index);
  const Vec2& goal_m = predicted_.field().goal_centre_m(Side::kEast);
  Vec2 direction = direction_of(goal_m - robot.position_m, Vec2(1, 0));
  for (const TrackedRobot& opponent : predicted_.now().opponents) {
    const Vec2 off = robot.position_m - opponent.position_m;
    const double distance_m = off.norm();
    if (distance_m < predicted_.style().avoid_opponents_m && distance_m > 1e-6)
      direction += off / distance_m * (predicted_.style().avoid_opponents_m - distance_m) *
                   predicted_.style().avoid_opponents;
  }
  const Vec2 edge_m(predicted_.field().half_length_m(), predicted_.field().half_width_m());
  for (int axis = 0; axis < 2; ++axis) {
    const double near =
        std::abs(robot.position_m[axis]) - (edge_m[axis] - predicted_.style().edge_m);
    if (near > 0)
      direction[axis] -=
          std::copysign(near / predicted_.style().edge_m * predicted_.style().avoid_lines,
                        robot.position_m[axis]);
  }
  const Vec2 heading = direction_of(direction, Vec2(1, 0));
  const double along = std::max(0.0, robot.heading.dot(heading));
  const Vec2 velocity_mps = slowed_with_ball(predicted_, predicted_.path().now_m(),
                                             heading * (predicted_.style().carry_mps * along));
  return carry_ball(robot, velocity_mps, heading, with_turning(choice_.strike, predicted_.style()));
}

void BallHandler::note_hold(const TrackedRobot& robot, bool holds) {
  if (!holds || holder_ != robot.number) taken_from_m_ = predicted_.path().now_m();
  holder_ = holds ? robot.number : -1;
}

// A dribble begins with any contact, and lasts until the ball is visibly apart from the robot.
void BallHandler::note_contacts() {
  const double most_m = predicted_.style().dribble_gap_m;
  if (most_m <= 0 || !predicted_.rules().has(RuleId::kBotDribbledBallTooFar)) return;
  const auto former = contact_from_m_;
  contact_from_m_.fill(std::nullopt);
  const Vec2& ball_m = predicted_.path().now_m();
  for (const TrackedRobot& robot : predicted_.now().own) {
    const auto number = static_cast<std::size_t>(robot.number);
    const double gap_m = distance_to_hull(ball_m, robot.position_m, robot.heading) - kBallRadius_m;
    if (gap_m < (former[number] ? most_m : std::min(most_m, kTouches_m)))
      contact_from_m_[number] = former[number].value_or(ball_m);
  }
}

// Whether the robot is about to touch the ball at a restart, so that a new choice would come too
// late.
bool BallHandler::is_committed(const TrackedRobot& robot) const {
  return predicted_.style().restart_commit_rad > 0 && is_restart(predicted_.now().play) &&
         restart_taker_ == robot.number &&
         (predicted_.path().now_m() - robot.position_m).norm() < kCommitted_m;
}

RobotCommand BallHandler::play(int index) {
  const TrackedRobot& robot = predicted_.robot(index);
  const Vec2& ball_m = predicted_.path().now_m();
  const BallInterception& interception = predicted_.interception(index);
  const bool holds = has_ball(robot, ball_m);
  if (!is_committed(robot)) choice_ = choose(index, holds ? ball_m : interception.point_m);
  restart_taker_ = is_restart(predicted_.now().play) ? robot.number : -1;
  choice_.strike.bend_rad =
      is_hurried(index) ? predicted_.style().pressed_bend_rad : predicted_.style().free_bend_rad;
  note_hold(robot, holds);
  if (predicted_.now().play == Play::kRunning && opponent_has_ball(predicted_) && !must_release())
    return holds ? face_off_.break_away(predicted_.now().time_s) : block_ball(predicted_, index);
  if (holds && choice_.kind == Choice::Kind::kCarry) return carry(index);
  RobotCommand command = strike(index);
  const bool is_pass = choice_.kind == Choice::Kind::kPass || choice_.kind == Choice::Kind::kChip;
  if (command.kick_mps > 0 && is_pass) {
    receiver_ = choice_.receiver;
    receiver_until_s_ = predicted_.now().time_s + predicted_.style().pass_flight_s;
  }
  return command;
}

RobotCommand BallHandler::take_restart(const TrackedRobot& robot, const Obstacles& obstacles,
                                       const DrivingStyle& style) const {
  Strike kick = choice_.strike;
  if (!kick.dribble) kick.kick_mps = std::max(kick.kick_mps, predicted_.style().restart_least_mps);
  kick.commit_rad = predicted_.style().restart_commit_rad;
  return take_kick(robot, predicted_.path().now_m(), kick, obstacles, style);
}

RobotCommand BallHandler::strike(int index) const {
  const TrackedRobot& robot = predicted_.robot(index);
  const BallPath& path = predicted_.path();
  const BallInterception& interception = predicted_.interception(index);
  Obstacles obstacles;
  // Close to the ball, the robot fights for it instead of driving around other robots.
  if ((interception.point_m - robot.position_m).norm() > predicted_.style().fight_m)
    robots_around(predicted_, index, interception.point_m, obstacles);
  const DrivingStyle style = predicted_.driving(index);
  if (predicted_.now().play != Play::kRunning) return take_restart(robot, obstacles, style);
  Strike now = with_turning(choice_.strike, predicted_.style());
  now.keep_off = out_of_field(predicted_.field(), path.now_m(), predicted_.style().near_line_m);
  if (is_hasty()) {
    now.tolerance_rad = predicted_.style().release_rad;
    if (predicted_.style().release_faster_mps > 0)
      now.kick_mps = predicted_.allowed_kick_mps(
          std::max(now.kick_mps,
                   robot.velocity_mps.dot(robot.heading) + predicted_.style().release_faster_mps));
  }
  return strike_ball(robot, path, interception, now, obstacles, style);
}

// Whether an opponent will reach the ball before this robot or soon after it.
bool BallHandler::is_hurried(int index) const {
  return predicted_.theirs().time_s <
         predicted_.interception(index).time_s + predicted_.style().hurry_s;
}

// Whether a goal scored straight from this kick would count.
bool BallHandler::may_score() const {
  return predicted_.now().play != Play::kIndirectFree ||
         !predicted_.rules().has(RuleId::kIndirectGoal) || predicted_.style().indirect_shots;
}

// Whether the taker of this restart may touch the ball again, so that it can take the ball along.
bool BallHandler::may_dribble_restart() const {
  return predicted_.style().dribbled_restart > 0 && is_restart(predicted_.now().play) &&
         predicted_.now().play != Play::kPenalty &&
         !predicted_.rules().has(RuleId::kAttackerDoubleTouchedBall);
}

// A kick does not help if the ball is not at the kicker, if an opponent also holds it, or if the
// kick would go backwards.
bool BallHandler::must_let_go(int index) const {
  const TrackedRobot& robot = predicted_.robot(index);
  const auto& from_m = contact_from_m_[static_cast<std::size_t>(robot.number)];
  if (!from_m || predicted_.now().play != Play::kRunning) return false;
  const Vec2& ball_m = predicted_.path().now_m();
  if (dribbled_m(*from_m) < hasty_share() * predicted_.rules().dribbling_m) return false;
  return !has_ball(robot, ball_m) || opponent_has_ball(predicted_) ||
         robot.heading.x() < kBackwards;
}

// The robot drives away from the ball, and out of its path.
RobotCommand BallHandler::let_go(int index) const {
  const TrackedRobot& robot = predicted_.robot(index);
  const BallPath& path = predicted_.path();
  const Vec2 away = direction_of(robot.position_m - path.now_m(), -robot.heading);
  const Vec2 beside = left_of(path.direction());
  const double side = beside.dot(away) < 0 ? -1.0 : 1.0;
  const double aside_mps = path.speed_mps() > kMoves_mps ? kLetGo_mps : 0.0;
  RobotCommand command;
  command.velocity_mps = to_local(away * kLetGo_mps + beside * (side * aside_mps), robot.heading);
  return command;
}

// The fraction of the allowed dribbling distance after which the ball must be kicked immediately,
// in any direction.
double BallHandler::hasty_share() const {
  return std::max(predicted_.style().dribbling_share, predicted_.style().hasty_share);
}

// Whether the ball has been dribbled so far that it must be passed on now (must_release()), or even
// kicked immediately in any direction (is_hasty()).
bool BallHandler::must_release() const { return has_dribbled(predicted_.style().dribbling_share); }
bool BallHandler::is_hasty() const { return has_dribbled(hasty_share()); }

// Whether the ball has been dribbled over the given fraction of the allowed dribbling distance.
bool BallHandler::has_dribbled(double share) const {
  if (!predicted_.rules().has(RuleId::kBotDribbledBallTooFar)) return false;
  Vec2 from_m = taken_from_m_;
  if (holder_ >= 0 && contact_from_m_[static_cast<std::size_t>(holder_)])
    from_m = *contact_from_m_[static_cast<std::size_t>(holder_)];
  return dribbled_m(from_m) > share * predicted_.rules().dribbling_m;
}

// How far from its starting point the ball will have been dribbled once the robot can part with it.
double BallHandler::dribbled_m(const Vec2& from_m) const {
  return (predicted_.path().now_m() - from_m).norm() +
         predicted_.style().release_lead_s * predicted_.path().speed_mps();
}

}  // namespace autoref::strategies
