#include "strategies/tactics/keeper.hpp"

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <optional>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/ball_path.hpp"
#include "strategies/tactics/duel.hpp"

namespace autoref::strategies {
namespace {

constexpr int kGoalLinePoints = 17;  // number of sample points on the goal line
constexpr double kBlockedBy_m = kRobotRadius_m + kBallRadius_m;
constexpr double kNearest_m = 50_mm;  // robots nearer to the ball, along the field, are ignored
// Fraction of the field's length; shots from farther away are rare.
constexpr double kFarthest = 0.62;
constexpr double kStrayCost_per_m = 1;  // in samples covered, per metre from the usual point
constexpr double kAimWidth_m = 0.15;    // points of the goal this near to the aim count more
constexpr double kAimWeight = 1.0;      // largest additional weight of such a point

using Weights = std::array<double, kGoalLinePoints>;

double sample_y(const Field& field, int i) {
  return (field.half_goal_m() - kBallRadius_m) * (2.0 * i / (kGoalLinePoints - 1) - 1);
}

// Sets the weights of all points behind a robot to zero.
void shade(const Field& field, const Vec2& from_m, const Vec2& robot_m, Weights& open) {
  const double to_robot_m = from_m.x() - robot_m.x();
  if (to_robot_m < kNearest_m || robot_m.x() < -field.half_length_m()) return;
  // Similar triangles, as in openings.cpp.
  const double stretch = (from_m.x() + field.half_length_m()) / to_robot_m;
  const double slope = (robot_m.y() - from_m.y()) / to_robot_m;
  const double half_m = kBlockedBy_m * stretch * std::sqrt(1 + slope * slope);
  const double middle_m = from_m.y() + (robot_m.y() - from_m.y()) * stretch;
  for (int i = 0; i < kGoalLinePoints; ++i) {
    if (std::abs(sample_y(field, i) - middle_m) < half_m) open[static_cast<std::size_t>(i)] = 0;
  }
}

Weights open_points(const PredictedState& predicted, const KeeperShadow& keeper) {
  Weights open;
  for (int i = 0; i < kGoalLinePoints; ++i) {
    double& weight = open[static_cast<std::size_t>(i)];
    weight = 1;
    if (!keeper.aim_y_m) continue;
    const double near =
        1 - std::abs(sample_y(predicted.field(), i) - *keeper.aim_y_m) / kAimWidth_m;
    weight += kAimWeight * std::max(0.0, near);
  }
  for (int i = 1; i < predicted.robots(); ++i)
    shade(predicted.field(), predicted.threat_m(), predicted.robot(i).position_m, open);
  return open;
}

// An open point of the goal line.
struct OpenPoint {
  double y_m;
  double weight;
};
using OpenPoints = boost::container::static_vector<OpenPoint, kGoalLinePoints>;

OpenPoints without_shaded(const Field& field, const Weights& open) {
  OpenPoints points;
  for (int i = 0; i < kGoalLinePoints; ++i) {
    const double weight = open[static_cast<std::size_t>(i)];
    if (weight > 0) points.push_back({sample_y(field, i), weight});
  }
  return points;
}

// How much a shadow around `middle_m` covers: the shadow's middle covers fully, its ends hardly at
// all.
double covered(const OpenPoints& open, double middle_m, double half_width_m) {
  double sum = 0;
  for (const OpenPoint& point : open) {
    const double off_m = point.y_m - middle_m;
    if (std::abs(off_m) >= half_width_m) continue;
    const double off = off_m / half_width_m;
    sum += point.weight * std::max(0.0, 1 - off * off);
  }
  return sum;
}

Vec2 on_goal_line(const Field& field, const Vec2& from_m, const Vec2& direction) {
  const double share = (-field.half_length_m() - from_m.x()) / direction.x();
  return {-field.half_length_m(), from_m.y() + share * direction.y()};
}

// Where an opponent with the ball is aiming, if that is in or near the goal.
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

// Where the keeper expects a shot to cross the keeper's line: in the middle of the open angle,
// shifted towards the point at which an opponent with the ball aims.
Vec2 expected_at(const PredictedState& predicted, const Vec2& halving) {
  const Vec2 middle_m = on_goal_line(predicted.field(), predicted.threat_m(), halving);
  const std::optional<Vec2> aim_m = aimed_at(predicted);
  return aim_m ? middle_m + (*aim_m - middle_m) * predicted.style().keeper_aim_trust : middle_m;
}

// `expected_m`, shifted towards the part of the goal that the keeper's team-mates leave open to a
// shot. The keeper stands on the line x = `stand_x`.
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

// Where the ball will cross the team's own goal line; nullopt unless this is in or near the goal.
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

std::optional<double> gap_for_keeper_m(const PredictedState& predicted,
                                       const KeeperShadow& keeper) {
  const Field& field = predicted.field();
  const double ahead_m = predicted.threat_m().x() + field.half_length_m();
  if (ahead_m < 2 * kNearest_m || ahead_m > kFarthest * field.length_m) return std::nullopt;
  const OpenPoints open = without_shaded(field, open_points(predicted, keeper));
  if (open.empty()) return std::nullopt;
  std::array<double, kGoalLinePoints> cover{};
  int best = 0;
  for (int i = 0; i < kGoalLinePoints; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double y_m = sample_y(field, i);
    cover[at] = covered(open, y_m, keeper.half_width_m);
    if (cover[at] > 0) cover[at] -= kStrayCost_per_m * std::abs(y_m - keeper.usual_y_m);
    if (cover[at] > cover[static_cast<std::size_t>(best)]) best = i;
  }
  const auto at = static_cast<std::size_t>(best);
  if (cover[at] <= 0) return std::nullopt;
  if (best == 0 || best == kGoalLinePoints - 1) return sample_y(field, best);
  // The vertex of the parabola through the best sample and its neighbours.
  const double bend = cover[at - 1] - 2 * cover[at] + cover[at + 1];
  const double shift = bend < 0 ? (cover[at - 1] - cover[at + 1]) / (2 * bend) : 0.0;
  const double step_m = sample_y(field, 1) - sample_y(field, 0);
  return sample_y(field, best) + std::clamp(shift, -0.5, 0.5) * step_m;
}

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
  if (halving.x() > -0.25) {  // the ball is to the side of the goal: cover the near post
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
