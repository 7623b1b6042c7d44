// The ball's motion through a sequence of detections, with gaps.
//
// A Kalman filter that knows how carpet slows a ball, sliding after a kick and rolling later
// (the league's two-phase model, medium carpet). A detection too far from where the ball should be
// means a kick or a bounce: the velocity is then learnt anew, within two frames.
//
// Where vision reports no height, each kick is followed by a ChipFlight (chip_flight.hpp): once it
// tells that the ball flies, place, velocity and height are those of the flight; until it can tell,
// the height is unknown and the place is the one that vision reports.
//
// An unseen ball goes on along its way for half a second, then counts as lying where it got to. A
// ball that was last seen at a robot's front, where the robot may hide it, moves along with the
// robot until it is seen again.
#pragma once

#include <optional>

#include "soccer/frame.hpp"
#include "soccer/tracks.hpp"
#include "soccer/units.hpp"
#include "tracking/chip_flight.hpp"
#include "tracking/motion_filter.hpp"

namespace autoref {

class BallTracker {
 public:
  static constexpr double kGoesOnUnseen_s = 500_ms;

  // `noise_m`: standard deviation of a detection's coordinates.
  explicit BallTracker(double noise_m);

  // `robots` are those of the same time. None before the ball was first seen.
  const std::optional<TrackedBall>& update(double time_s,
                                           const std::optional<BallObservation>& seen,
                                           const PerSide<TrackedRobots>& robots);

 private:
  // The robot at whose front the ball is, and where it is in the robot's frame.
  struct Holder {
    RobotId robot;
    Vec2 position_m{0, 0};
  };

  void start(const BallObservation& seen);
  void predict(double duration_s);
  void correct(const BallObservation& seen, double gap_s);
  void follow_kick(const BallObservation& seen, double time_s);
  void take_over(const ChipEstimate& flight);
  void fly_on(double duration_s);
  void move_with_holder(const PerSide<TrackedRobots>& robots);
  std::optional<Holder> holder_among(const PerSide<TrackedRobots>& robots) const;

  double noise_m_;
  MotionFilter<2> motion_;
  ChipFlight chip_;
  double kick_s_ = 0;          // when chip_ began
  bool follows_kick_ = false;  // with chip_
  double rise_mps_ = 0;        // of a flight that chip_ tells
  std::optional<TrackedBall> ball_;
  std::optional<Holder> holder_;
  double kicked_mps_ = 0;  // speed after the last change that was no carpet's; 0: rolls
  double updated_s_ = 0;
  double seen_s_ = 0;
  Vec2 camera_m_{0, 0};  // of the last detection
};

}  // namespace autoref
