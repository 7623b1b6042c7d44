#include "sim/ball.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {
namespace {

// Whether the point is over a goal's side wall where that wall continues to the field's wall.
bool is_over_goal_side(const Field& field, const Vec2& point_m) {
  const double beside_m = std::abs(point_m.y()) - field.half_goal_m();
  return field.goal_sides_reach_wall && std::abs(point_m.x()) > field.half_length_m() &&
         beside_m >= 0.0 && beside_m <= field.goal_wall_thickness_m;
}

double bounced_vertical(const ContactParameters& contacts, const Ball& ball) {
  return std::max(contacts.top_leaving_mps, -contacts.top_restitution * ball.vertical_mps());
}

// `velocity_mps`, whose component along `outwards`, relative to the robot or goal under the ball,
// is raised to at least `least_mps`.
Vec2 leaving(const Vec2& velocity_mps, const Vec2& top_mps, const Vec2& outwards,
             double least_mps) {
  const double now = (velocity_mps - top_mps).dot(outwards);
  return velocity_mps + std::max(0.0, least_mps - now) * outwards;
}

// Segment-circle intersection: the first fraction of the segment from `from_m` to `to_m` at which
// the distance from the origin is `near_m`.
std::optional<double> collision(const Vec2& from_m, const Vec2& to_m, double near_m) {
  const Vec2 path_m = to_m - from_m;
  const double towards = -from_m.dot(path_m);
  const double spare = from_m.squaredNorm() - near_m * near_m;
  if (towards <= 0.0) return std::nullopt;
  if (spare <= 0.0) return 0.0;
  const double length2 = path_m.squaredNorm();
  const double root2 = towards * towards - length2 * spare;
  if (root2 < 0.0) return std::nullopt;
  const double share = (towards - std::sqrt(root2)) / length2;
  return share <= 1.0 ? std::optional(share) : std::nullopt;
}

}  // namespace

// With deceleration a, a ball without spin slides at v - a t while its surface speed grows as
// inertia * a t; they are equal at v * inertia / (1 + inertia), which must be switch_ratio * v.
// (Solid sphere: inertia 2.5, ratio 5/7.)
Ball::Ball(const BallParameters& parameters)
    : parameters_(parameters),
      inertia_(parameters.switch_ratio / (1.0 - parameters.switch_ratio)) {}

void Ball::set(const BallState& state) {
  height_m_ = state.height_m;
  vertical_mps_ = state.vertical_mps;
  is_rolling_ = state.is_rolling && !is_in_air();
  spin_mps_ = is_rolling_ ? state.velocity_mps : Vec2(0.0, 0.0);
  has_landed_ = false;
}

void Ball::kick(double vertical_mps) {
  vertical_mps_ = vertical_mps;
  spin_mps_.setZero();
  is_rolling_ = false;
  has_landed_ = false;
}

void Ball::hold(double duration_s) {
  spin_mps_.setZero();
  is_rolling_ = true;
  has_landed_ = false;
  if (!is_in_air()) return;
  // Semi-implicit Euler integration; a rising ball starts to fall immediately.
  vertical_mps_ = std::min(vertical_mps_, 0.0) - kGravity_mps2 * duration_s;
  height_m_ = std::max(0.0, height_m_ + vertical_mps_ * duration_s);
  if (height_m_ == 0.0) vertical_mps_ = 0.0;
}

// One step of Coulomb friction. Friction slows the ball by `lost` and spins it up by inertia *
// lost, so sliding removes (1 + inertia) * lost from the slip. If the slip is smaller than that, it
// vanishes within the step and the ball rolls.
Vec2 Ball::slowed(const Vec2& velocity_mps, double duration_s, double rest_mps) {
  if (is_in_air()) return velocity_mps;
  const double lost_mps = parameters_.slide_mps2 * duration_s;
  const Vec2 slip_mps = velocity_mps - spin_mps_;
  const double slip = slip_mps.norm();
  is_rolling_ = slip <= (1.0 + inertia_) * lost_mps;
  if (!is_rolling_) {
    const Vec2 change_mps = slip_mps * (lost_mps / slip);
    spin_mps_ += inertia_ * change_mps;
    return velocity_mps - change_mps;
  }
  // Sliding friction acts at the contact point, so it conserves the angular momentum about that
  // point, which is proportional to inertia * velocity + spin.
  const Vec2 rolling_mps = (inertia_ * velocity_mps + spin_mps_) / (1.0 + inertia_);
  const double speed = rolling_mps.norm();
  const double slowing_mps2 = parameters_.roll_mps2 + parameters_.roll_per_s * speed;
  const double left = speed - slowing_mps2 * duration_s;
  spin_mps_ = left < rest_mps ? Vec2(0.0, 0.0) : Vec2(rolling_mps * (left / speed));
  return spin_mps_;
}

// Exact ballistic flight. If the parabola reaches the carpet within the step, the ball lands there
// and flies on for the rest of the step; a second landing waits for the next step.
Vec2 Ball::flown(const Vec2& velocity_mps, double duration_s) {
  if (!is_in_air()) return velocity_mps;
  Vec2 flying_mps = velocity_mps;
  double rest_s = duration_s;
  const double end_m = height_m_ + vertical_mps_ * rest_s - kGravity_mps2 * rest_s * rest_s / 2.0;
  if (end_m <= 0.0) {
    const double falls_mps =
        std::sqrt(vertical_mps_ * vertical_mps_ + 2.0 * kGravity_mps2 * height_m_);
    rest_s = std::max(0.0, rest_s - (vertical_mps_ + falls_mps) / kGravity_mps2);
    height_m_ = 0.0;
    vertical_mps_ = -falls_mps;
    flying_mps = land(flying_mps);
    if (!is_in_air()) return flying_mps;
  }
  height_m_ =
      std::max(0.0, height_m_ + vertical_mps_ * rest_s - kGravity_mps2 * rest_s * rest_s / 2.0);
  vertical_mps_ -= kGravity_mps2 * rest_s;
  return flying_mps;
}

Vec2 Ball::land(const Vec2& velocity_mps) {
  const double kept = has_landed_ ? parameters_.hop_later_xy : parameters_.hop_first_xy;
  const double kept_upwards = has_landed_ ? parameters_.hop_later_z : parameters_.hop_first_z;
  has_landed_ = true;
  // Restitution applies to the upward motion, and a fixed loss applies to the motion along the
  // carpet. Afterwards, the surface speed from the ball's spin equals its velocity.
  vertical_mps_ *= -kept_upwards;
  const double hop_m = vertical_mps_ * vertical_mps_ / (2.0 * kGravity_mps2);
  spin_mps_ = kept * velocity_mps;
  if (hop_m < parameters_.rolls_below_hop_m) vertical_mps_ = 0.0;
  return spin_mps_;
}

void Ball::collide(const Vec2& change_mps) {
  const double change = change_mps.norm();
  if (change < 1e-9) return;
  // Treats the change of velocity as the normal impulse per unit mass. By Coulomb's law, friction
  // at the contact is at most contact_friction times this impulse. Friction brakes the spin along
  // the normal and never reverses it.
  const Vec2 along = change_mps / change;
  const double spin = spin_mps_.dot(along);
  const double lost = std::min(std::abs(spin), inertia_ * parameters_.contact_friction * change);
  spin_mps_ -= std::copysign(lost, spin) * along;
}

void Ball::bounce_in_air(double height_m, double vertical_mps) {
  height_m_ = height_m;
  vertical_mps_ = vertical_mps;
}

bool is_over_goal(const Field& field, const Vec2& point_m) {
  const double x = std::abs(point_m.x()) - field.half_length_m();
  return x >= 0.0 && x <= field.goal_depth_m + field.goal_wall_thickness_m &&
         std::abs(point_m.y()) <= field.half_goal_m() + field.goal_wall_thickness_m;
}

bool is_in_goal(const Field& field, const Vec2& point_m) {
  const double x = std::abs(point_m.x()) - field.half_length_m();
  return x >= 0.0 && x <= field.goal_depth_m && std::abs(point_m.y()) <= field.half_goal_m();
}

std::optional<Vec2> bounced_off_top(const Field& field, const ContactParameters& contacts,
                                    const Box2dBridge& bodies, int robots, double former_height_m,
                                    Ball& ball) {
  // The ball hits a top if it crosses the height of the top within the step. Since a step is short,
  // its end approximates the position of the crossing.
  const double height_m = ball.height_m();
  const BodyState& body = bodies.ball();
  const double net_m = field.goal_opening_height_m;
  if (former_height_m < net_m && height_m >= net_m && is_in_goal(field, body.position_m)) {
    ball.bounce_in_air(former_height_m, 0.0);
    return body.velocity_mps;
  }
  if (former_height_m >= net_m && height_m < net_m && is_over_goal(field, body.position_m)) {
    ball.bounce_in_air(net_m, bounced_vertical(contacts, ball));
    return leaving(body.velocity_mps, {0.0, 0.0}, {std::copysign(1.0, body.position_m.x()), 0.0},
                   contacts.top_leaving_mps);
  }
  if (former_height_m >= net_m && height_m < net_m && is_over_goal_side(field, body.position_m)) {
    ball.bounce_in_air(net_m, bounced_vertical(contacts, ball));
    return leaving(body.velocity_mps, {0.0, 0.0}, {0.0, std::copysign(1.0, body.position_m.y())},
                   contacts.top_leaving_mps);
  }
  if (former_height_m < kRobotHeight_m || height_m >= kRobotHeight_m) return std::nullopt;
  for (int i = 0; i < robots; ++i) {
    if (!bodies.is_on(i)) continue;
    const BodyState& robot = bodies.robot(i);
    if (distance_to_hull(body.position_m, robot.position_m, robot.heading) >= 0.0) continue;
    ball.bounce_in_air(kRobotHeight_m, bounced_vertical(contacts, ball));
    return leaving(body.velocity_mps, robot.velocity_mps,
                   direction_of(body.position_m - robot.position_m, robot.heading),
                   contacts.top_leaving_mps);
  }
  return std::nullopt;
}

std::optional<BallState> bounced_off_bar(const Field& field, double restitution,
                                         const BallState& former, const BallState& now) {
  if (std::abs(now.position_m.y()) > field.half_goal_m()) return std::nullopt;
  // Coordinates in a side view along the bar: x as on the field, then the height.
  const Vec2 bar_m(
      std::copysign(field.half_length_m() + field.goal_bar_radius_m, now.position_m.x()),
      field.goal_opening_height_m + field.goal_bar_radius_m);
  const auto from_bar_m = [&bar_m](const BallState& ball) {
    return Vec2(Vec2(ball.position_m.x(), ball.height_m + kBallRadius_m) - bar_m);
  };
  const std::optional<double> share =
      collision(from_bar_m(former), from_bar_m(now), kBallRadius_m + field.goal_bar_radius_m);
  if (!share) return std::nullopt;
  BallState met = now;
  met.position_m = former.position_m + *share * (now.position_m - former.position_m);
  met.height_m = former.height_m + *share * (now.height_m - former.height_m);
  const Vec2 outwards = from_bar_m(met).normalized();
  const double closing_mps = -Vec2(now.velocity_mps.x(), now.vertical_mps).dot(outwards);
  if (closing_mps <= 0.0) return std::nullopt;
  // Newton's law of restitution along the line of centres, without friction.
  met.velocity_mps.x() += (1.0 + restitution) * closing_mps * outwards.x();
  met.vertical_mps += (1.0 + restitution) * closing_mps * outwards.y();
  return met;
}

}  // namespace autoref::sim
