// What tells a touch from what the carpet does to the ball.
#pragma once

#include "soccer/units.hpp"

namespace autoref::referee {

// Defaults suit a camera whose only error is the rounding to float millimetres.
struct TouchParameters {
  // The carpet changes the ball's velocity by no more than this. Sliding balls lose 3.0 to 3.9
  // m/s2 on the league's carpets; smaller values take friction for touches, larger ones miss soft
  // touches.
  double carpet_mps2 = 5.0;
  // A change of velocity from frame to frame beyond the carpet's and up to this is nothing: camera
  // rounding makes 0.001 m/s at 60 Hz.
  double jump_mps = 0.02;
  // Standard deviation of the camera's ball positions; the detector sets it to the noise it is told
  // of, and widens the distances below by three of them.
  double position_noise_m = 0.0;
  // A ball between two free ways is where both meet, up to this distance a frame: carpet friction
  // and the physics' own steps.
  double intersection_tolerance_m = 3_mm;
  // A robot farther from the ball's way than this did not touch it. Kickers reach 15 mm beyond the
  // plate.
  double reach_m = 20_mm;
  // A bounce happens at no distance; where and when it was is known to this.
  double contact_m = 5_mm;
  // Of two robots of different sides the one nearer by this touched the ball; nearer to each other
  // than this, nobody knows.
  double lead_m = 5_mm;
  // A push moves the ball along the hull's normal, within 45 degrees: friction turns it by 13.
  double bounce_cos = 0.7;
  // A kick moves the ball along the robot's front, within 25 degrees.
  double kick_cos = 0.9;
  // Bodies in contact are this near to each other: physics leaves half a millimetre between them.
  double touching_m = 1_mm;
  // Two hulls this near have the ball pinned between them: when one moves it, so may the other.
  double pinned_m = 2_mm;
  // A hull that stays within touching_m of a ball faster than this pushes or carries it.
  double carried_mps = 0.03_mps;
  // A hull that near has pushed the ball once its velocity grows by this along the push, beyond how
  // it changed just before. Soft touches are below the carpet's own changes.
  double soft_push_mps = 0.02_mps;
  // A ball unseen for longer may have been touched meanwhile.
  double longest_gap_s = 100_ms;
};

}  // namespace autoref::referee
