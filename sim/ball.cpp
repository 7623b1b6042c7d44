#include "sim/ball.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/units.hpp"

namespace autoref::sim {

// With deceleration a, a ball without spin slides at v - a t while its surface speed grows as
// inertia * a t; they meet at v * inertia / (1 + inertia), which must equal switch_ratio * v.
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
  // Semi-implicit Euler; a rising ball starts to fall at once.
  vertical_mps_ = std::min(vertical_mps_, 0.0) - kGravity_mps2 * duration_s;
  height_m_ = std::max(0.0, height_m_ + vertical_mps_ * duration_s);
  if (height_m_ == 0.0) vertical_mps_ = 0.0;
}

// One step of Coulomb friction. Sliding removes (1 + inertia) * lost from the slip: friction slows
// the ball by `lost` and spins it up by inertia * lost. If the slip is smaller than that, it
// vanishes within the step and the ball rolls.
Vec2 Ball::slowed(const Vec2& velocity_mps, double duration_s) {
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
  spin_mps_ = left < parameters_.rest_mps ? Vec2(0.0, 0.0) : Vec2(rolling_mps * (left / speed));
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
  // Restitution upwards, a fixed loss along the carpet; afterwards the ball spins as fast as it
  // moves.
  vertical_mps_ *= -kept_upwards;
  const double hop_m = vertical_mps_ * vertical_mps_ / (2.0 * kGravity_mps2);
  spin_mps_ = kept * velocity_mps;
  if (hop_m < parameters_.rolls_below_hop_m) vertical_mps_ = 0.0;
  return spin_mps_;
}

void Ball::collide(const Vec2& change_mps) {
  const double change = change_mps.norm();
  if (change < 1e-9) return;
  // Takes the change as the normal impulse per mass. By Coulomb's law, friction at the contact is
  // at most contact_friction times that; it brakes the spin along the normal and never reverses it.
  const Vec2 along = change_mps / change;
  const double spin = spin_mps_.dot(along);
  const double lost = std::min(std::abs(spin), inertia_ * parameters_.contact_friction * change);
  spin_mps_ -= std::copysign(lost, spin) * along;
}

void Ball::bounce_in_air(double height_m, double vertical_mps) {
  height_m_ = height_m;
  vertical_mps_ = vertical_mps;
}

}  // namespace autoref::sim
