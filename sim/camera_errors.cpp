#include "sim/camera_errors.hpp"

#include <cmath>

#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {
namespace {

// Of the four cameras, 0 and 3 are diagonally opposite, as are 1 and 2.
double sign_of(int camera) { return camera == 0 || camera == 3 ? 1.0 : -1.0; }

double drawn_angle(RandomStream& chance) { return 2.0 * kPi * chance.uniform(); }

}  // namespace

CameraErrors::CameraErrors(const VisionParameters& parameters, const Field& field,
                           RandomStream& chance)
    : error_m_(parameters.camera_error_m),
      error_rad_(parameters.camera_error_rad),
      waves_per_m_(2.0 * kPi / field.length_m, 2.0 * kPi / field.width_m) {
  if (are_zero()) return;
  const double half_square = std::sqrt(0.5);
  offset_m_ = heading_of(drawn_angle(chance)) * (error_m_ * half_square);
  phases_rad_.x() = drawn_angle(chance);
  phases_rad_.y() = drawn_angle(chance);
  offset_rad_ = (chance.uniform() < 0.5 ? -1.0 : 1.0) * error_rad_ * half_square;
  heading_phase_rad_ = drawn_angle(chance);
}

// The mean of sin^2 over a period is 1/2, so the two coordinates of the warp have the mean square
// error_m^2 / 2 together.
Vec2 CameraErrors::position_m(int camera, const Vec2& at_m) const {
  const Vec2 angles_rad = at_m.cwiseProduct(waves_per_m_) + phases_rad_;
  const Vec2 warp_m =
      Vec2(sin_cos(angles_rad.x()).sin, sin_cos(angles_rad.y()).sin) * (error_m_ * std::sqrt(0.5));
  return sign_of(camera) * (offset_m_ + warp_m);
}

double CameraErrors::heading_rad(int camera, const Vec2& at_m) const {
  const double angle_rad = at_m.x() * waves_per_m_.x() + heading_phase_rad_;
  return sign_of(camera) * (offset_rad_ + error_rad_ * sin_cos(angle_rad).sin);
}

}  // namespace autoref::sim
