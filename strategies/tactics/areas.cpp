#include "strategies/tactics/areas.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

constexpr double kBesideBox_m = 10_mm;
constexpr double kGradientStep_m = 1_mm;
constexpr double kInTheWay_m = 0.35;  // distance along the field from a robot in the goal to an
                                      // opponent in front of it
// Distance across the field at which a robot passes an opponent.
constexpr double kPast_m = 2 * kRobotRadius_m + 10_mm;
constexpr double kGoalBraking_mps2 = 2.5;
constexpr double kSlowsWithin_m = 1.5;  // at most 3 m/s^2 are needed to stop from full speed

// The corner of a box-shaped area to steer for if the straight path to `target_m` leads through the
// area or passes closer than `apart_m` to it; otherwise the target.
Vec2 around_box(const Field& field, Side side, double apart_m, const TrackedRobot& robot,
                const Vec2& target_m) {
  const DefenceArea& area = field.defence_area;
  if (area.shape != DefenceArea::Shape::kBox) return target_m;
  // The box, in coordinates in which it is at +x.
  const double sign = goal_sign(side);
  const Vec2 from_m = robot.position_m * sign;
  const Vec2 to_m = target_m * sign;
  const double front_x = field.half_length_m() - area.depth_m - apart_m;
  const double side_y = area.straight_m / 2 + apart_m;
  const auto is_inside = [&](const Vec2& p) { return p.x() > front_x && std::abs(p.y()) < side_y; };
  if (is_inside(from_m) || is_inside(to_m)) return target_m;
  // Where the path enters the box's range in x, and where it leaves it.
  const Vec2 path = to_m - from_m;
  if (from_m.x() <= front_x && to_m.x() <= front_x) return target_m;
  double first = 0;
  double last = 1;
  if (from_m.x() <= front_x) first = (front_x - from_m.x()) / path.x();
  if (to_m.x() <= front_x) last = (front_x - from_m.x()) / path.x();
  const double first_y = from_m.y() + first * path.y();
  const double last_y = from_m.y() + last * path.y();
  const bool passes = std::min(first_y, last_y) < side_y && std::max(first_y, last_y) > -side_y;
  if (!passes) return target_m;
  const double beside =
      std::abs(from_m.y()) >= side_y && from_m.x() > front_x ? from_m.y() : to_m.y();
  return Vec2(front_x - kBesideBox_m, std::copysign(side_y + kBesideBox_m, beside)) * sign;
}

// The limits for leaving the opponents' area.
Limits leaving(const PredictedState& predicted) {
  Limits limits;
  limits.keep_from_area_m = predicted.rules().attacker_to_area_m + kRobotRadius_m + kBesideBox_m;
  limits.may_enter_own_area = true;
  limits.beyond_lines_m = 1;
  return limits;
}

// Keeps a robot from driving into the opponents' goal.
Vec2 slowed_before_goal(const Field& field, const TrackedRobot& robot, const Vec2& velocity_mps) {
  if (std::abs(robot.position_m.y()) > field.half_goal_m() + kRobotRadius_m) return velocity_mps;
  const double room_m =
      std::max(0.0, field.half_length_m() - kRobotRadius_m - kBesideBox_m - robot.position_m.x());
  return {std::min(velocity_mps.x(), std::sqrt(2 * kGoalBraking_mps2 * room_m)), velocity_mps.y()};
}

}  // namespace

std::optional<Vec2> exit_from_goal(const PredictedState& predicted, const TrackedRobot& robot) {
  const Field& field = predicted.field();
  const double beyond_m = robot.position_m.x() - field.half_length_m();
  if (!predicted.style().around_boxes || beyond_m < -kRobotRadius_m ||
      beyond_m > field.goal_depth_m || std::abs(robot.position_m.y()) > field.half_goal_m())
    return std::nullopt;
  const double reach_m = field.half_goal_m() - kRobotRadius_m - kBesideBox_m;
  // First drives past any opponent, usually the keeper, that stands in the way.
  for (const TrackedRobot& opponent : predicted.now().opponents) {
    const Vec2 off_m = robot.position_m - opponent.position_m;
    if (off_m.x() < 0 || off_m.x() > kInTheWay_m || std::abs(off_m.y()) > kPast_m) continue;
    const double side_y =
        opponent.position_m.y() + std::copysign(kPast_m + kBesideBox_m, off_m.y());
    const double other_y =
        opponent.position_m.y() - std::copysign(kPast_m + kBesideBox_m, off_m.y());
    return Vec2(robot.position_m.x(), std::abs(side_y) <= reach_m ? side_y : other_y);
  }
  return Vec2(field.half_length_m() - 2 * kRobotRadius_m,
              std::clamp(robot.position_m.y(), -reach_m, reach_m));
}

Vec2 around_boxes(const PredictedState& predicted, const TrackedRobot& robot,
                  const Vec2& target_m) {
  if (!predicted.style().around_boxes) return target_m;
  if (predicted.limits().keep_from_area_m > 0) {
    Vec2 out_m = permitted_by_all(predicted.field(), robot.position_m, predicted.position_m(),
                                  leaving(predicted));
    if ((out_m - robot.position_m).norm() > kBesideBox_m) return out_m;
  }
  const double own_m = kRobotRadius_m;
  const double their_m = std::max(own_m, predicted.limits().keep_from_area_m);
  const Vec2 via_m = around_box(predicted.field(), Side::kEast, their_m, robot, target_m);
  return around_box(predicted.field(), Side::kWest, own_m, robot, via_m);
}

Vec2 slowed_before_area(const PredictedState& predicted, Side side, const Vec2& point_m,
                        double room_m, const Vec2& velocity_mps) {
  const double braking_mps2 = predicted.style().area_braking_mps2;
  if (braking_mps2 <= 0 || room_m > kSlowsWithin_m) return velocity_mps;
  const auto distance_m = [&](const Vec2& p) {
    return distance_to_defence_area(predicted.field(), side, p);
  };
  const double here_m = distance_m(point_m);
  const Vec2 away = direction_of(Vec2(distance_m(point_m + Vec2(kGradientStep_m, 0)) - here_m,
                                      distance_m(point_m + Vec2(0, kGradientStep_m)) - here_m),
                                 Vec2(-goal_sign(side), 0));
  const double most_mps = std::sqrt(2 * braking_mps2 * std::max(0.0, room_m));
  const double excess_mps = -velocity_mps.dot(away) - most_mps;
  return excess_mps > 0 ? Vec2(velocity_mps + away * excess_mps) : velocity_mps;
}

void stay_out_of_areas(const PredictedState& predicted, int index, RobotCommand& command) {
  if (predicted.style().area_braking_mps2 <= 0 || predicted.now().play != Play::kRunning) return;
  const TrackedRobot& robot = predicted.robot(index);
  Vec2 velocity_mps =
      slowed_before_goal(predicted.field(), robot, to_world(command.velocity_mps, robot.heading));
  const PerSide<RuleId> rule{
      {RuleId::kDefenderInDefenseArea, RuleId::kAttackerTouchedBallInDefenseArea}};
  for (const Side side : kSides) {
    if (!predicted.rules().has(rule[side])) continue;
    const double room_m =
        distance_to_defence_area(predicted.field(), side, robot.position_m) - kRobotRadius_m;
    velocity_mps = slowed_before_area(predicted, side, robot.position_m, room_m, velocity_mps);
  }
  command.velocity_mps = to_local(velocity_mps, robot.heading);
}

}  // namespace autoref::strategies
