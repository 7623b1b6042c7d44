// How the ball loses speed: on the carpet, in the air and at landings.
//
// On the carpet it slides after a kick and rolls later. The ball's spin is kept as the speed its
// surface would roll at. While that differs from the ball's own speed, the carpet slows the ball
// and spins it up; where they meet, it rolls. A ball kicked without spin at v then starts to roll
// at switch_ratio * v, as in the closed forms of the league's two-phase model, and a ball that
// rebounds or is pushed gets its phases from the same law.
#pragma once

#include "sim/configuration.hpp"
#include "sim/world.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

class Ball {
 public:
  explicit Ball(const BallParameters& parameters);

  double height_m() const { return height_m_; }  // of the lowest point
  double vertical_mps() const { return vertical_mps_; }
  bool is_rolling() const { return is_rolling_; }
  bool is_in_air() const { return height_m_ > 0.0 || vertical_mps_ != 0.0; }

  // Takes over a state: a rolling ball spins as fast as it moves, another one not at all.
  void set(const BallState& state);
  // A kick leaves the ball without spin; `vertical_mps` is positive for a chip.
  void kick(double vertical_mps);
  // A ball held for ball placement sinks to the carpet and does not spin.
  void hold(double duration_s);

  // The velocity after `duration_s` on the carpet; unchanged in the air.
  Vec2 slowed(const Vec2& velocity_mps, double duration_s);
  // The velocity after flying for `duration_s`, landings included; unchanged on the carpet.
  Vec2 flown(const Vec2& velocity_mps, double duration_s);
  // A collision changed the velocity by `change_mps`; friction there takes spin along it.
  void collide(const Vec2& change_mps);
  // The flying ball hit something at height `height_m`, and leaves it at `vertical_mps`.
  void bounce_in_air(double height_m, double vertical_mps);

 private:
  Vec2 land(const Vec2& velocity_mps);

  BallParameters parameters_;
  double inertia_;  // how much slower friction slows the ball than it spins it up
  Vec2 spin_mps_{0, 0};
  double height_m_ = 0;
  double vertical_mps_ = 0;
  bool is_rolling_ = true;
  bool has_landed_ = false;  // since the last kick
};

}  // namespace autoref::sim
