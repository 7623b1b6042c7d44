#include "sim/placement.hpp"

#include <algorithm>
#include <cmath>

#include "sim/ball.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

// The corners between a position behind a goal line and the field; empty for a position on the
// field.
Route route_to_field(const Field& field, const Vec2& position_m, double clearance_m) {
  Route direction;
  const double before_line_m = field.half_length_m() - clearance_m;
  if (std::abs(position_m.x()) <= before_line_m) return direction;
  const double end = std::copysign(1.0, position_m.x());
  if (is_in_goal(field, position_m)) {
    const double inside_m = field.half_goal_m() - clearance_m;
    const double y = std::clamp(position_m.y(), -inside_m, inside_m);
    direction.push_back({position_m.x(), y});
    direction.push_back({end * before_line_m, y});
    return direction;
  }
  const double beside_m = field.half_goal_m() + field.goal_wall_thickness_m + clearance_m;
  const double behind_m = field.half_length_m();
  // If side walls reach the field's wall, the route crosses them, since a hand lifts the ball over
  // them. A ball exactly behind the goal's centre is carried around the left side of the goal, as
  // seen from the field.
  const double flank = position_m.y() == 0.0 ? end : std::copysign(1.0, position_m.y());
  const double y = flank * std::max(beside_m, std::abs(position_m.y()));
  if (y != position_m.y() && std::abs(position_m.x()) > behind_m)
    direction.push_back({position_m.x(), y});
  direction.push_back(
      {end * before_line_m, std::abs(position_m.x()) > behind_m ? y : position_m.y()});
  return direction;
}

}  // namespace

Route route_between(const Field& field, const Vec2& start_m, const Vec2& target_m,
                    double clearance_m) {
  Route route = route_to_field(field, start_m, clearance_m);
  const Route back = route_to_field(field, target_m, clearance_m);
  route.insert(route.end(), back.rbegin(), back.rend());
  route.push_back(target_m);
  return route;
}

void Carrier::start(const Vec2& from_m, const Vec2& target_m) {
  route_ = route_between(field_, from_m, target_m, parameters_.clearance_m);
  next_ = 0;
  from_m_ = from_m;
  time_s_ = 0.0;
}

Vec2 Carrier::carry(double duration_s) {
  time_s_ += duration_s;
  // Time left over at a corner counts towards the next leg.
  while (time_s_ >= leg_duration_s()) {
    if (next_ + 1 == route_.size()) return route_.back();
    time_s_ -= leg_duration_s();
    from_m_ = route_[next_++];
  }
  return from_m_ + (route_[next_] - from_m_) * (path_m(time_s_) / leg_length_m());
}

double Carrier::leg_length_m() const { return (route_[next_] - from_m_).norm(); }

// A trapezoidal velocity profile with equal ramps; triangular if the leg is too short to reach the
// top speed.
double Carrier::leg_duration_s() const {
  const double ramp_s = parameters_.speed_mps / parameters_.acceleration_mps2;
  const double length_m = leg_length_m();
  const double ramps_m = parameters_.speed_mps * ramp_s;
  if (length_m <= ramps_m) return 2.0 * std::sqrt(length_m / parameters_.acceleration_mps2);
  return 2.0 * ramp_s + (length_m - ramps_m) / parameters_.speed_mps;
}

// Integral of the velocity profile; the ramp down is the mirror image of the ramp up.
double Carrier::path_m(double time_s) const {
  const double a = parameters_.acceleration_mps2;
  const double total_s = leg_duration_s();
  const double ramp_s = std::min(parameters_.speed_mps / a, total_s / 2.0);
  const double left_s = total_s - time_s;
  if (time_s < ramp_s) return a * time_s * time_s / 2.0;
  if (left_s < ramp_s) return leg_length_m() - a * left_s * left_s / 2.0;
  return a * ramp_s * (time_s - ramp_s / 2.0);
}

}  // namespace autoref::sim
