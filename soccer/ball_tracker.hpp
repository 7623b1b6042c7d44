// The ball's motion through a sequence of sightings, with gaps.
//
// A Kalman filter that knows how carpet slows a ball, sliding after a kick and rolling later
// (the league's two-phase model, medium carpet). A sighting too far from where the ball should be
// means a kick or a bounce: the velocity is then learnt anew, within two frames.
//
// An unseen ball goes on along its way for half a second, then counts as lying where it got to. A
// ball that was last seen at a robot's front, where the robot may hide it, moves along with the
// robot until it is seen again.
#pragma once

#include <optional>

#include "soccer/frame.hpp"
#include "soccer/motion_filter.hpp"
#include "soccer/tracks.hpp"
#include "soccer/units.hpp"

namespace autoref {

class BallTracker {
 public:
  static constexpr double kGoesOnUnseen_s = 500_ms;

  // `noise_m`: standard deviation of a sighting's coordinates.
  explicit BallTracker(double noise_m);

  // `robots` are those of the same time. None before the ball was first seen.
  const std::optional<TrackedBall>& update(double time_s,
                                           const std::optional<BallObservation>& seen,
                                           const PerSide<TrackedRobots>& robots);

 private:
  // The robot at whose front the ball is, and where it is in the robot's frame.
  struct Holder {
    RobotId robot;
    Vec2 place_m{0, 0};
  };

  void start(const BallObservation& seen);
  void predict(double duration_s);
  void correct(const BallObservation& seen, double duration_s);
  void move_with_holder(const PerSide<TrackedRobots>& robots);
  std::optional<Holder> holder_among(const PerSide<TrackedRobots>& robots) const;

  MotionFilter<2> motion_;
  std::optional<TrackedBall> ball_;
  std::optional<Holder> holder_;
  double kicked_mps_ = 0;  // speed after the last change that was no carpet's; 0: rolls
  double updated_s_ = 0;
  double seen_s_ = 0;
};

}  // namespace autoref
