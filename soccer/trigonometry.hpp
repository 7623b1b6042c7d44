// Trigonometry with bit-identical results on every x86-64 machine.
//
// The C library uses different code for sin, cos and atan2 on machines with fused multiply-add, and
// the last bit of the result then differs; a game with the same seed would end differently on
// another host. These functions use only additions, multiplications and divisions, which IEEE 754
// defines exactly. All angles are in radians.
#pragma once

namespace autoref {

struct SinCos {
  double sin;
  double cos;
};

// Sine and cosine of `angle_rad`, within 4e-16 of the exact value for |angle_rad| <= 1e5.
SinCos sin_cos(double angle_rad);

// The angle of the vector (x, y) in [-pi, pi], accurate to 1e-15; 0 for the zero vector.
double atan2_exact(double y, double x);

// `angle_rad` shifted by a multiple of 2 pi into [-pi, pi].
double wrap_angle(double angle_rad);

}  // namespace autoref
