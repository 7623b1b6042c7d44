// Systematic errors of the cameras' calibration.
#pragma once

#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/random.hpp"

namespace autoref::sim {

// A constant offset plus a warp of one period over the field's length and width, each with half of
// the mean square. Drawn once, so that no place on the field is favoured over many games.
// Neighbouring cameras have opposite errors.
class CameraErrors {
 public:
  // Draws no number if the parameters are 0.
  CameraErrors(const VisionParameters& parameters, const Field& field, RandomStream& chance);

  bool are_zero() const { return error_m_ == 0.0 && error_rad_ == 0.0; }

  // The error of a camera (index as in camera_positions) at a point of the field.
  Vec2 position_m(int camera, const Vec2& at_m) const;
  double heading_rad(int camera, const Vec2& at_m) const;

 private:
  double error_m_;
  double error_rad_;
  Vec2 waves_per_m_;  // rad/m along x and y
  Vec2 offset_m_{0, 0};
  double offset_rad_ = 0.0;
  Vec2 phases_rad_{0, 0};
  double heading_phase_rad_ = 0.0;
};

}  // namespace autoref::sim
