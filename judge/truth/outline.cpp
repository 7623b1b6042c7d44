#include "judge/truth/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr int kPoints = 256;
constexpr double kInContact_m = 5_mm;

// Points of the round hull, cut off at the front plate, and the plate's corners.
using Outline = std::array<Vec2, kPoints + 2>;

Outline outline() {
  Outline points;
  for (int i = 0; i < kPoints; ++i) {
    Vec2 point = kRobotRadius_m * heading_of(2 * 3.14159265358979323846 * i / kPoints);
    point.x() = std::min(point.x(), kFrontDistance_m);
    points[static_cast<std::size_t>(i)] = point;
  }
  points[kPoints] = {kFrontDistance_m, kHalfPlate_m};
  points[kPoints + 1] = {kFrontDistance_m, -kHalfPlate_m};
  return points;
}

template <typename Distance>
Reach reach(const sim::RobotState& robot, const Distance& distance_m) {
  // Brute force over sampled points: independent of the referee's closed formulas.
  static const Outline kOutline = outline();
  Reach reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec2& point : kOutline) {
    const double m = distance_m(Vec2(robot.position_m + to_world(point, robot.heading)));
    reach.nearest_m = std::min(reach.nearest_m, m);
    reach.farthest_m = std::max(reach.farthest_m, m);
  }
  return reach;
}

// Fraction of the step at which a coordinate reaches +-limit; nullopt if it does not.
std::optional<double> share_at(double from, double to, double limit) {
  if (std::abs(to) <= limit) return std::nullopt;
  const double line = std::copysign(limit, to);
  return from == to ? 0.0 : std::clamp((line - from) / (to - from), 0.0, 1.0);
}

}  // namespace

Reach reach_to_area(const Field& field, Side side, const sim::RobotState& robot) {
  // Far from the area a bound is enough.
  const double centre_m = distance_to_defence_area(field, side, robot.position_m);
  if (centre_m > 0.5) return {centre_m - kRobotRadius_m, centre_m + kRobotRadius_m};
  return reach(robot,
               [&](const Vec2& at_m) { return distance_to_defence_area(field, side, at_m); });
}

Reach reach_into_half(Side side, const sim::RobotState& robot) {
  return reach(robot, [side](const Vec2& at_m) { return goal_sign(side) * at_m.x(); });
}

double hull_to_ball_m(const sim::RobotState& robot, const sim::BallState& ball) {
  return distance_to_hull(ball.position_m, robot.position_m, robot.heading);
}

bool are_in_contact(const sim::RobotState& a, const sim::RobotState& b) {
  return (a.position_m - b.position_m).norm() < 2 * kRobotRadius_m + kInContact_m;
}

double inside_m(const Field& field, const Vec2& ball_m) {
  return std::min(field.half_length_m() - std::abs(ball_m.x()),
                  field.half_width_m() - std::abs(ball_m.y())) +
         kBallRadius_m;
}

std::optional<Crossing> find_crossing(const Field& field, const sim::BallState& before,
                                      const sim::BallState& now) {
  if (inside_m(field, now.position_m) >= 0 || inside_m(field, before.position_m) < 0) {
    return std::nullopt;
  }
  const Vec2& a = before.position_m;
  const Vec2& b = now.position_m;
  const auto goal = share_at(a.x(), b.x(), field.half_length_m() + kBallRadius_m);
  const auto touch = share_at(a.y(), b.y(), field.half_width_m() + kBallRadius_m);
  Crossing crossing;
  // The ball leaves over the line it reaches first on the straight path between the two frames.
  crossing.over_goal_line = goal && (!touch || *goal <= *touch);
  crossing.share = crossing.over_goal_line ? *goal : *touch;
  crossing.point_m = a + crossing.share * (b - a);
  crossing.height_m = before.height_m + crossing.share * (now.height_m - before.height_m);
  crossing.end = crossing.point_m.x() < 0 ? Side::kWest : Side::kEast;
  crossing.into_goal = crossing.over_goal_line &&
                       std::abs(crossing.point_m.y()) < field.half_goal_m() &&
                       crossing.height_m + kBallRadius_m < field.goal_opening_height_m;
  return crossing;
}

bool is_keepers_ball(const TrueFrame& frame, Side side) {
  if (distance_to_defence_area(frame.field, side, frame.now.ball.position_m) > 0) return false;
  if (frame.rules.edition == Edition::kRules2026) return true;
  const Contacts& contacts = frame.ball.contacts();
  return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
    return contact.robot.side == side && frame.is_keeper(contact.robot);
  });
}

}  // namespace autoref::judge::ground_truth
