#include "strategies/tactics/place_ball.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/strike.hpp"

namespace autoref::strategies {
namespace {

// Distance from robot to ball in contact.
constexpr double kGrip_m = kFrontDistance_m + kBallRadius_m;
// Distance from where the robot lines up to where it grips the ball.
constexpr double kRunUp_m = 120_mm;
constexpr double kNearWall_m = 250_mm;  // a ball nearer to a wall is first pulled inwards
constexpr double kInwards_m = 300_mm;   // distance by which such a ball is pulled inwards
constexpr double kBesideGoal_m =
    450_mm;  // a ball at or behind the goal line this near to a post is first pulled inwards
constexpr double kApproach_mps = 2.5;
constexpr double kGrip_mps = 0.35;
constexpr double kPress_s = 0.25;  // time to make sure of the contact
constexpr double kPressing_mps = 0.1;
constexpr double kPull_mps = 1.6;
constexpr double kPull_mps2 = 1.3;  // the dribbler loses the ball in harder motion
constexpr double kTurn_radps = 2.0;
constexpr double kTurn_radps2 = 8.0;
constexpr double kSetDown_m = 25_mm;      // distance from the ball to its position
constexpr double kGoodEnough_m = 110_mm;  // a ball at rest this near to its position stays
constexpr double kStraight_m = 250_mm;    // the last part is straight
constexpr double kRests_mps = 0.15;       // maximum speed of a tracked ball at rest
constexpr double kBrake_s = 0.3;          // time to come to rest with the ball
constexpr double kRelease_s = 0.5;        // time for the ball to come to rest after the dribbler is
                                          // switched off
constexpr double kSlowly_s = 1.0;         // until then, the robot backs away slowly
constexpr double kSlowly_mps = 0.25;
constexpr double kLeave_mps = 1.0;
constexpr double kLeave_m = 0.75;    // distance from the robot's centre to the ball
constexpr double kPatience_s = 9.0;  // time without the ball after which another robot tries
constexpr double kClear_m = 0.68;    // distance from the centres of other robots to the ball's path

bool is_field_player(const PredictedState& predicted, const TrackedRobot& robot) {
  return robot.number != predicted.robot(0).number;
}

double slewed(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

}  // namespace

// The robot nearest to the ball, except the keeper.
int BallPlacer::choose() const {
  int nearest = -1;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int i = predicted_.robots() > 1 ? 1 : 0; i < predicted_.robots(); ++i) {
    const TrackedRobot& robot = predicted_.robot(i);
    double distance_m = (robot.position_m - ball_m_).norm();
    if (robot.number == former_) distance_m += predicted_.field().length_m;
    if (distance_m >= nearest_m) continue;
    nearest_m = distance_m;
    nearest = i;
  }
  return nearest;
}

void BallPlacer::update(const TrackedBall& tracked) {
  const TeamView& now = predicted_.now();
  step_s_ = now.time_s - now_s_;
  now_s_ = now.time_s;
  is_hidden_ = tracked.velocity_mps == Vec2(0, 0) && tracked.position_m == tracked_m_;
  tracked_m_ = tracked.position_m;
  ball_m_ = predicted_.path().now_m();
  index_ = -1;
  if (now.placing_is_ours != true || !now.placement_m) {
    number_ = former_ = -1;
    return;
  }
  const bool is_impatient = !holds_ && !set_down_s_ && now_s_ - since_s_ > kPatience_s;
  for (int i = 0; i < predicted_.robots(); ++i) {
    if (predicted_.robot(i).number == number_ && !is_impatient) index_ = i;
  }
  if (index_ >= 0) return;
  former_ = number_;
  index_ = choose();
  if (index_ < 0) return;
  number_ = predicted_.robot(index_).number;
  since_s_ = now_s_;
  holds_ = false;
  set_down_s_.reset();
}

// The designated position, or an intermediate position if the ball must first be pulled away from a
// wall or a goal.
Vec2 BallPlacer::next_goal_m() const {
  const Field& field = predicted_.field();
  const Vec2& ball_m = ball_m_;
  Vec2 inwards(0, 0);
  if (std::abs(ball_m.x()) > field.wall_x_m() - kNearWall_m)
    inwards.x() = -std::copysign(kInwards_m, ball_m.x());
  if (std::abs(ball_m.y()) > field.wall_y_m() - kNearWall_m)
    inwards.y() = -std::copysign(kInwards_m, ball_m.y());
  const bool is_beside_goal = std::abs(ball_m.x()) > field.half_length_m() - kInwards_m / 2 &&
                              std::abs(ball_m.y()) < field.half_goal_m() + kBesideGoal_m;
  if (is_beside_goal) inwards = {-std::copysign(kInwards_m, ball_m.x()), 0};
  return inwards == Vec2(0, 0) ? predicted_.position_m() : Vec2(ball_m + inwards);
}

bool BallPlacer::still_holds(const TrackedRobot& robot) const {
  if (has_ball(robot, ball_m_)) return true;
  const Vec2 local_m = to_local(ball_m_ - robot.position_m, robot.heading);
  return holds_ && local_m.x() > 0 && local_m.x() < kGrip_m + 35_mm &&
         std::abs(local_m.y()) < 60_mm;
}

RobotCommand BallPlacer::play() {
  const TrackedRobot& robot = predicted_.robot(index_);
  const bool held = holds_;
  // Cameras do not see a ball behind the robot; the ball is still at the plate.
  if (held && is_hidden_) ball_m_ = robot.position_m + robot.heading * kGrip_m;
  const Vec2& ball_m = ball_m_;
  const double left_m = (predicted_.position_m() - ball_m).norm();
  holds_ = still_holds(robot);
  if (!held && holds_) {
    velocity_mps_ = robot.velocity_mps;
    turn_radps_ = 0;
    held_since_s_ = now_s_;
  }
  const bool rests = predicted_.path().speed_mps() < kRests_mps;
  if (!set_down_s_ &&
      ((holds_ && left_m < kSetDown_m) || (!holds_ && rests && left_m < kGoodEnough_m)))
    set_down_s_ = now_s_;
  if (set_down_s_ && left_m > kGoodEnough_m + 20_mm) set_down_s_.reset();
  if (set_down_s_) return set_down(robot);
  const Vec2 goal_m = next_goal_m();
  if (holds_ && now_s_ - held_since_s_ > kPress_s) return pull_ball(robot, goal_m);
  if (holds_) return press(robot);
  const Vec2 pull = direction_of(goal_m - ball_m, -robot.heading);
  return approach(robot, pull);
}

// The robot lines up on the side to which the ball is to be pulled, facing the ball.
RobotCommand BallPlacer::approach(const TrackedRobot& robot, const Vec2& pull) {
  const Vec2& ball_m = ball_m_;
  const Vec2 from_ball_m = robot.position_m - ball_m;
  const double along_m = from_ball_m.dot(pull) - kGrip_m;
  const double aside_m = std::abs(cross(pull, from_ball_m));
  const bool is_in_lane = along_m > -30_mm && along_m < kRunUp_m + 80_mm &&
                          aside_m < 15_mm + 0.15 * std::max(0.0, along_m);
  if (is_in_lane && std::abs(angle_between(robot.heading, -pull)) < 0.2) return grip(robot, pull);
  const Vec2 stand_m = ball_m + pull * (kGrip_m + kRunUp_m);
  Obstacles obstacles;
  robots_around(predicted_, index_, stand_m, obstacles);
  obstacles.push_back({ball_m, kRobotRadius_m + kBallRadius_m + 40_mm});
  DrivingStyle style = predicted_.driving(index_);
  style.speed_mps = std::min(predicted_.abilities(index_).speed_mps, kApproach_mps);
  return drive_via(robot, steer_for(robot, stand_m, obstacles), {stand_m, -pull}, style);
}

RobotCommand BallPlacer::grip(const TrackedRobot& robot, const Vec2& pull) {
  const Vec2 from_ball_m = robot.position_m - ball_m_;
  const DrivingStyle style = predicted_.driving(index_);
  const double along_m = from_ball_m.dot(pull) - kGrip_m;
  const double aside_m = cross(pull, from_ball_m);
  const double speed_mps = std::min(kGrip_mps, 0.1 + 3 * std::max(0.0, along_m));
  const Vec2 velocity_mps = predicted_.path().velocity_mps() - pull * speed_mps -
                            left_of(pull) * (style.approach_per_s * aside_m);
  RobotCommand command = drive_with(robot, velocity_mps, -pull, style);
  command.dribble = true;
  return command;
}

// The robot makes sure that it is in contact with the ball.
RobotCommand BallPlacer::press(const TrackedRobot& robot) {
  velocity_mps_ = robot.heading * kPressing_mps;
  RobotCommand command =
      drive_with(robot, velocity_mps_, robot.heading, predicted_.driving(index_));
  command.dribble = true;
  return command;
}

// The robot drives backwards with gentle accelerations. It turns first if the ball is on the wrong
// side.
RobotCommand BallPlacer::pull_ball(const TrackedRobot& robot, const Vec2& goal_m) {
  const Vec2 offset_m = goal_m - ball_m_;
  const double left_m = offset_m.norm();
  const Vec2 robot_goal_m = robot.position_m + offset_m;
  Obstacles obstacles;
  robots_around(predicted_, index_, robot_goal_m, obstacles);
  const bool is_straight = left_m < kStraight_m;
  const Vec2 steer_m = is_straight ? robot_goal_m : steer_for(robot, robot_goal_m, obstacles);
  const Vec2 direction = direction_of(steer_m - robot.position_m, -robot.heading);
  const double error_rad = angle_between(robot.heading, -direction);
  const bool is_at_wall = goal_m != predicted_.position_m();
  const double turn_radps =
      is_straight || is_at_wall ? 0 : std::clamp(3 * error_rad, -kTurn_radps, kTurn_radps);
  const double share = is_straight || is_at_wall ? 1 : std::max(0.0, -robot.heading.dot(direction));
  const double speed_mps = std::min(kPull_mps, std::sqrt(2 * 0.7 * kPull_mps2 * left_m)) * share;
  turn_radps_ = slewed(turn_radps_, turn_radps, kTurn_radps2 * step_s_);
  velocity_mps_ += clamp_norm(direction * speed_mps - velocity_mps_, kPull_mps2 * step_s_);
  RobotCommand command;
  command.velocity_mps = to_local(velocity_mps_, robot.heading);
  command.angular_velocity_radps = turn_radps_;
  command.dribble = true;
  return command;
}

// The robot comes to rest, switches the dribbler off, waits, and backs away, slowly at first.
RobotCommand BallPlacer::set_down(const TrackedRobot& robot) {
  const double waited_s = now_s_ - *set_down_s_;
  RobotCommand command;
  velocity_mps_ = {0, 0};
  if (waited_s < kRelease_s) {
    command.dribble = waited_s < kBrake_s;
    return command;
  }
  const Vec2 from_ball_m = robot.position_m - ball_m_;
  const Vec2 away = direction_of(from_ball_m, -robot.heading);
  const double left_m = kLeave_m - from_ball_m.norm();
  if (left_m < 0) return command;
  const double limit_mps = waited_s < kSlowly_s ? kSlowly_mps : kLeave_mps;
  const Vec2 out = off_walls(predicted_.field(), robot.position_m, away, left_m);
  return drive_with(robot, out * std::min(limit_mps, 0.1 + 3 * left_m), -away,
                    predicted_.driving(index_));
}

bool must_clear_placement(const PredictedState& predicted) {
  const TeamView& now = predicted.now();
  constexpr double kPlaced_m = 100_mm;
  return predicted.style().clear_of_placement && now.placement_m && predicted.is_waiting() &&
         now.next && !now.next_is_ours && predicted.rules().has(RuleId::kBotInterferedPlacement) &&
         (*now.placement_m - now.ball.position_m).norm() > kPlaced_m;
}

std::optional<Waypoint> clear_of_placement(const PredictedState& predicted,
                                           const TrackedRobot& robot, const Vec2& waypoint_m) {
  const TeamView& now = predicted.now();
  if (!now.placement_m || !(now.placing_is_ours || must_clear_placement(predicted)))
    return std::nullopt;
  const Vec2& ball_m = predicted.path().now_m();
  const auto nearest = [&](const Vec2& point_m) {
    return nearest_on_segment(point_m, ball_m, *now.placement_m);
  };
  constexpr int kSamples = 8;
  bool is_free = true;
  for (int i = 0; i <= kSamples; ++i) {
    const Vec2 point_m =
        robot.position_m + (waypoint_m - robot.position_m) * (static_cast<double>(i) / kSamples);
    is_free = is_free && (point_m - nearest(point_m)).norm() > kClear_m;
  }
  if (is_free) return std::nullopt;
  const Vec2 path_m = nearest(robot.position_m);
  const Vec2 off_m = robot.position_m - path_m;
  const Vec2 away = direction_of(off_m, direction_of(-path_m, Vec2(-1, 0)));
  const double room_m = std::max(off_m.norm(), kClear_m + 50_mm);
  const Vec2 aside_m = path_m + away * room_m;
  if (!predicted.style().clear_of_placement || !is_field_player(predicted, robot))
    return Waypoint{aside_m, robot.heading};
  Limits limits;
  limits.keep_from_area_m = predicted.limits().keep_from_area_m;
  return Waypoint{permitted(predicted.field(), aside_m, ball_m, limits), robot.heading};
}

RobotCommand step_aside(const PredictedState& predicted, int index, const Waypoint& waypoint) {
  const TrackedRobot& robot = predicted.robot(index);
  Waypoint goal = waypoint;
  if (const auto exit_m = exit_from_behind_goal(predicted.field(), robot.position_m))
    goal.position_m = *exit_m;
  Obstacles obstacles;
  robots_around(predicted, index, goal.position_m, obstacles);
  return drive_via(robot, steer_for(robot, goal.position_m, obstacles), goal,
                   predicted.driving(index));
}

}  // namespace autoref::strategies
