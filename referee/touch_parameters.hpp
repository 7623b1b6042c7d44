// Thresholds that separate touches from the effects of the carpet.
#pragma once

#include "soccer/units.hpp"

namespace autoref::referee {

// The defaults suit a camera whose only error is rounding to float millimetres.
struct TouchParameters {
  // Largest deceleration that the carpet causes. Sliding balls lose 3.0 to 3.9 m/s2 on the league's
  // carpets; smaller values mistake friction for touches, larger values miss soft touches.
  double carpet_mps2 = 5.0;
  // Velocity changes between frames up to this limit, beyond those that the carpet causes, are
  // ignored: camera rounding causes 0.001 m/s at 60 Hz.
  double jump_mps = 0.02;
  // Standard deviation of the camera's ball positions. The detector sets it to the configured noise
  // and widens the distances below by three standard deviations.
  double position_noise_m = 0.0;
  // Between two free paths the ball may be this far per frame from their intersection, because of
  // carpet friction and the physics' sub-steps.
  double intersection_tolerance_m = 3_mm;
  // A robot farther from the ball's path than this did not touch it. Kickers reach 15 mm beyond the
  // plate.
  double reach_m = 20_mm;
  // Largest measured gap at a bounce. The true gap is zero, but time and position of the bounce are
  // only known with this accuracy.
  double contact_m = 5_mm;
  // If a robot is nearer to the ball than any robot of the other side by more than this, it touched
  // the ball; otherwise the toucher is unknown.
  double lead_m = 5_mm;
  // A push moves the ball along the hull's normal, within 45 degrees: friction deflects it by 13
  // degrees.
  double bounce_cos = 0.7;
  // A kick moves the ball along the robot's front, within 25 degrees.
  double kick_cos = 0.9;
  // Largest gap between bodies in contact. The physics engine leaves gaps of half a millimetre.
  double touching_m = 1_mm;
  // Two hulls this close to the ball pin it between them: if one moves it, so may the other.
  double pinned_m = 2_mm;
  // If a hull is within touching_m of a ball that is faster than this, it pushes or carries the
  // ball.
  double carried_mps = 0.03_mps;
  // If the ball's velocity along the direction of the push increases by at least this much more
  // than its previous change explains, a hull within touching_m has pushed the ball. Soft touches
  // change it less than the carpet does.
  double soft_push_mps = 0.02_mps;
  // If the ball is unseen for longer, it may have been touched meanwhile.
  double longest_gap_s = 100_ms;
};

}  // namespace autoref::referee
