#include "strategies/tactics/keeper.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/reach.hpp"
#include "strategies/tactics/duel.hpp"
#include "strategies/tactics/goal_gap.hpp"

namespace autoref::strategies {
namespace {

Vec2 on_goal_line(const Field& field, const Vec2& from_m, const Vec2& direction) {
  const double share = (-field.half_length_m() - from_m.x()) / direction.x();
  return {-field.half_length_m(), from_m.y() + share * direction.y()};
}

// Where an opponent with the ball aims, if that is in the goal or near it.
std::optional<Vec2> aimed_at(const PredictedState& predicted) {
  const Field& field = predicted.field();
  if (!opponent_has_ball(predicted)) return std::nullopt;
  const Vec2& heading =
      predicted.now().opponents[static_cast<std::size_t>(predicted.their_fastest())].heading;
  if (heading.x() > -0.1) return std::nullopt;
  const Vec2 aim_m = on_goal_line(field, predicted.position_m(), heading);
  if (std::abs(aim_m.y()) > field.half_goal_m() + predicted.style().keeper_beside_post_m)
    return std::nullopt;
  return aim_m;
}

// Where the keeper expects a shot to cross its line: in the middle of the open angle, shifted
// towards the point at which an opponent with the ball aims.
Vec2 expected_at(const PredictedState& predicted, const Vec2& halving) {
  const Vec2 middle_m = on_goal_line(predicted.field(), predicted.threat_m(), halving);
  const std::optional<Vec2> aim_m = aimed_at(predicted);
  return aim_m ? middle_m + (*aim_m - middle_m) * predicted.style().keeper_aim_trust : middle_m;
}

// `expected_m`, shifted to the part of the goal that the keeper's team-mates leave open to a shot.
// The keeper stands on the line x = `stand_x`.
Vec2 shifted_to_gap(const PredictedState& predicted, const Vec2& expected_m, double stand_x) {
  const double share = predicted.style().keeper_fills_gap;
  if (share <= 0) return expected_m;
  const Vec2& ball_m = predicted.threat_m();
  const double stretch = (ball_m.x() + predicted.field().half_length_m()) /
                         std::max(kRobotRadius_m, ball_m.x() - stand_x);
  const Vec2 line_m = expected_m - ball_m;
  KeeperShadow shadow;
  shadow.half_width_m =
      (kRobotRadius_m + kBallRadius_m) * stretch * line_m.norm() / std::abs(line_m.x());
  shadow.usual_y_m = expected_m.y();
  if (const auto aim_m = aimed_at(predicted)) shadow.aim_y_m = aim_m->y();
  const std::optional<double> gap_y = gap_for_keeper_m(predicted, shadow);
  return gap_y ? expected_m + Vec2(0, share * (*gap_y - expected_m.y())) : expected_m;
}

// Time until the ball, at its current speed, is at a point of its path.
double arrival_s(const BallPath& path, const Vec2& point_m) {
  return (point_m - path.now_m()).norm() / std::max(0.1, path.speed_mps());
}

// Where the ball will cross the team's own goal line; nullopt unless it will cross the line in the
// goal or near it.
std::optional<Vec2> shot_at(const PredictedState& predicted) {
  const BallPath& path = predicted.path();
  const double goal_x = -predicted.field().half_length_m();
  if (path.direction().x() > -0.1 || path.speed_mps() < predicted.style().keeper_shot_mps)
    return std::nullopt;
  const double share = (goal_x - path.now_m().x()) / path.direction().x();
  if (share < 0) return std::nullopt;
  const double y = path.now_m().y() + share * path.direction().y();
  if (std::abs(y) > predicted.field().half_goal_m() + predicted.style().keeper_beside_post_m)
    return std::nullopt;
  if (path.end_m().x() > goal_x + 0.3) return std::nullopt;  // the ball stops before the line
  return Vec2(goal_x, y);
}

}  // namespace

Waypoint keeper_position(const PredictedState& predicted, const TrackedRobot& keeper) {
  const Field& field = predicted.field();
  const double least_x =
      -field.half_length_m() + kRobotRadius_m + predicted.style().keeper_off_line_m;
  if (const auto crossing_m = shot_at(predicted)) {
    // The nearest point of the ball's path that is in front of the line and not behind the ball.
    Vec2 position_m = nearest_on_segment(keeper.position_m, *crossing_m, predicted.path().now_m());
    if (position_m.x() < least_x) {
      const Vec2 direction = predicted.path().direction();
      position_m += direction * ((least_x - position_m.x()) / direction.x());
    }
    return facing_ball(predicted, position_m);
  }
  const Vec2& ball_m = predicted.threat_m();
  const Vec2 left_post_m(-field.half_length_m(), field.half_goal_m());
  const Vec2 right_post_m(-field.half_length_m(), -field.half_goal_m());
  const Vec2 to_left = direction_of(left_post_m - ball_m, Vec2(-1, 0));
  const Vec2 to_right = direction_of(right_post_m - ball_m, Vec2(-1, 0));
  // The sum of two unit vectors points along the bisector of their angle.
  const Vec2 halving = direction_of(to_left + to_right, Vec2(-1, 0));
  const double out_m = predicted.style().keeper_out_m;
  const double stand_x = -field.half_length_m() +
                         std::max(out_m, kRobotRadius_m + predicted.style().keeper_off_line_m);
  if (halving.x() > -0.25) {  // the ball is beside the goal: cover the near post
    const double y = std::copysign(field.half_goal_m() - kRobotRadius_m, ball_m.y());
    return facing_ball(predicted, {least_x, y});
  }
  const double x = std::min(stand_x, ball_m.x() - kRobotRadius_m);
  const Vec2 direction = shifted_to_gap(predicted, expected_at(predicted, halving), x) - ball_m;
  const double y = ball_m.y() + direction.y() * (x - ball_m.x()) / direction.x();
  const double reach_m = field.half_goal_m() - kRobotRadius_m / 2;
  return facing_ball(predicted, {std::max(x, least_x), std::clamp(y, -reach_m, reach_m)});
}

RobotCommand keep_goal(const PredictedState& predicted, int index) {
  const TrackedRobot& keeper = predicted.robot(index);
  const Waypoint waypoint = keeper_position(predicted, keeper);
  DrivingStyle style = predicted.driving(index);
  const bool is_late = (waypoint.position_m - keeper.position_m).norm() > 50_mm;
  if (shot_at(predicted) && is_late) style.braking_mps2 = predicted.abilities(index).braking_mps2;
  Vec2 target_m = waypoint.position_m;
  if (const auto path_m = exit_from_behind_goal(predicted.field(), keeper.position_m))
    target_m = *path_m;
  if (shot_at(predicted) && predicted.style().keeper_dives &&
      arrival_s(predicted.path(), target_m) <
          time_to_s(keeper, target_m, predicted.abilities(index))) {
    const Vec2 dive = direction_of(target_m - keeper.position_m, waypoint.heading);
    RobotCommand command = drive_with(keeper, dive * style.speed_mps, waypoint.heading, style);
    command.dribble = true;
    return command;
  }
  RobotCommand command = drive_via(keeper, target_m, {target_m, waypoint.heading}, style);
  command.dribble = true;
  return command;
}

bool is_keepers_ball(const PredictedState& predicted) {
  const Vec2& ball_m = predicted.path().now_m();
  return distance_to_defence_area(predicted.field(), Side::kWest, ball_m) <
             predicted.style().keeper_area_margin_m &&
         ball_m.x() > -predicted.field().half_length_m() &&
         predicted.path().speed_mps() < predicted.style().keeper_fetch_mps;
}

}  // namespace autoref::strategies
