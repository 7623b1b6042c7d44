// Trigonometry that gives the same bits on every x86-64 machine.
//
// The C library picks other code for sin, cos and atan2 on machines with fused multiply-add, and
// the last bit of the result differs with it; a game that starts from the same seed would then end
// differently on another host. These functions use additions, multiplications and divisions only,
// which IEEE 754 fixes. All angles are in radians.
#pragma once

namespace autoref {

struct SinCos {
  double sin;
  double cos;
};

// Sine and cosine of `angle_rad`, within 4e-16 of the truth for |angle_rad| <= 1e5.
SinCos sin_cos(double angle_rad);

// The angle of the vector (x, y) in [-pi, pi], within 1e-15; 0 for the zero vector.
double atan2_exact(double y, double x);

// `angle_rad` plus the multiple of 2 pi that brings it into [-pi, pi].
double wrap_angle(double angle_rad);

}  // namespace autoref
