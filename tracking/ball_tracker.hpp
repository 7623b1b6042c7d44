// Estimates the ball's motion from a sequence of detections with gaps.
//
// This is a Kalman filter that models deceleration by the carpet: the ball slides after a kick and
// rolls later (the league's two-phase model, medium carpet). A detection outside the innovation
// gate is taken for a kick or a bounce: the velocity covariance is inflated, and the filter adopts
// the new velocity within two frames.
//
// If vision reports no height, each kick is followed by a ChipFlight (chip_flight.hpp). Once it
// detects a flight, it supplies position, velocity and height; until it decides, the height is
// unknown and the position is as reported by vision.
//
// An unseen ball is assumed to keep moving for half a second and then to stop. A ball last seen at
// a robot's front, where the robot may occlude it, moves with the robot until it is seen again.
#pragma once

#include <optional>

#include "soccer/frame.hpp"
#include "soccer/tracks.hpp"
#include "soccer/units.hpp"
#include "tracking/chip_flight.hpp"
#include "tracking/motion_filter.hpp"

namespace autoref::tracking {

class BallTracker {
 public:
  static constexpr double kGoesOnUnseen_s = 500_ms;

  // `noise_m`: standard deviation of a detection's coordinates.
  explicit BallTracker(double noise_m);

  // `robots` are the robots' tracks at the same time. Returns nullopt until the ball has been seen.
  const std::optional<TrackedBall>& update(double time_s,
                                           const std::optional<BallObservation>& seen,
                                           const PerSide<TrackedRobots>& robots);

 private:
  // The robot with the ball at its front, and the ball's position in the robot's frame.
  struct Holder {
    RobotId robot;
    Vec2 position_m{0, 0};
  };

  void start(const BallObservation& seen);
  void predict(double duration_s);
  void correct(const BallObservation& seen, double gap_s);
  void follow_kick(const BallObservation& seen, double time_s,
                   const PerSide<TrackedRobots>& robots);
  bool is_at_kicker(const Vec2& ball_m, const PerSide<TrackedRobots>& robots) const;
  void take_over(const ChipEstimate& flight);
  void fly_on(double duration_s);
  void move_with_holder(const PerSide<TrackedRobots>& robots);
  std::optional<Holder> holder_among(const PerSide<TrackedRobots>& robots) const;

  double noise_m_;
  MotionFilter<2> motion_;
  ChipFlight chip_;
  double kick_s_ = 0;              // time of the kick for which chip_ was started
  bool follows_kick_ = false;      // whether chip_ is in use
  std::optional<RobotId> kicker_;  // the robot nearest to the ball in the first frame after the
                                   // kick
  double rise_mps_ = 0;            // vertical speed of the flight that chip_ detected
  std::optional<TrackedBall> ball_;
  std::optional<Holder> holder_;
  double kicked_mps_ = 0;  // speed after the last change not caused by the carpet; 0 if rolling
  double updated_s_ = 0;
  double seen_s_ = 0;
  Vec2 camera_m_{0, 0};  // position of the camera that made the last detection
};

}  // namespace autoref::tracking
