#include "tracking/ball_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::tracking {
namespace {

// These values are between those of the carpet models in the league's simulators.
constexpr double kSlide_mps2 = 3.4;
constexpr double kRoll_mps2 = 0.3;
constexpr double kSwitchRatio = 0.67;

constexpr double kBallLeastNoise_m = 0.05e-3;
constexpr double kBallProcessNoise_m2ps3 = 0.1;
constexpr double kBallAnySpeed_mps = 8.0;
// Chi-square with two degrees of freedom: a consistent filter exceeds it once in 3000 detections.
constexpr double kBallInnovationGate = 16.0;
constexpr double kFasterThanAnyBall_mps = 25.0;  // at higher speeds the ball was relocated
constexpr double kAtFront_m = 15_mm;             // maximum gap between ball and plate

constexpr double kSlowestChip_mps = 1.0;
constexpr double kNewKick_mps = 1.0;  // minimum velocity change of a new kick
// Standard deviation of a kick's time, in frames. A kick late in a frame does not appear until one
// frame later.
constexpr double kKickTime = 0.6;
constexpr double kKickPosition_m = 5_mm;  // standard deviation of a kick's position
constexpr double kLeastFlight_m = 1e-3;   // minimum estimated height of a flying ball
// After this time, a chipped ball is 0.1 m from its kicker, even as the camera sees it.
constexpr double kLeavesRobot_s = 50_ms;
constexpr double kAtHull_m = 5_mm;  // maximum gap between ball and hull, plus the noise
// Largest distance from the robot's hull in the frame after the kick.
constexpr double kKickerNear_m = 100_mm;
constexpr double kLongestKick_s = 4.0;  // a chip at 5.5 m/s has stopped bouncing long before this

// The robot nearest to the ball, if it may have kicked it.
std::optional<RobotId> nearest_robot(const Vec2& ball_m, const PerSide<TrackedRobots>& robots) {
  std::optional<RobotId> nearest;
  double nearest_m2 = square(kRobotRadius_m + kKickerNear_m);
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : robots[side]) {
      const double distance_m2 = (robot.position_m - ball_m).squaredNorm();
      if (!(distance_m2 < nearest_m2)) continue;
      nearest_m2 = distance_m2;
      nearest = RobotId{side, robot.number};
    }
  }
  return nearest;
}

}  // namespace

BallTracker::BallTracker(double noise_m)
    : noise_m_(std::max(noise_m, kBallLeastNoise_m)),
      motion_({noise_m_, kBallProcessNoise_m2ps3, kBallAnySpeed_mps}),
      chip_(noise_m_) {}

const std::optional<TrackedBall>& BallTracker::update(double time_s,
                                                      const std::optional<BallObservation>& seen,
                                                      const PerSide<TrackedRobots>& robots) {
  if (!ball_ && !seen) return ball_;
  const double duration_s = time_s - updated_s_;
  if (ball_ && duration_s <= 0) return ball_;
  updated_s_ = time_s;
  if (!ball_) {
    start(*seen);
  } else {
    predict(duration_s);
    if (seen) correct(*seen, time_s - seen_s_);
  }
  if (seen) {
    seen_s_ = time_s;
    camera_m_ = seen->seen_from.position_m;
    if (seen->height_m) {
      ball_->height_m = *seen->height_m;
    } else {
      follow_kick(*seen, time_s, robots);
    }
  } else if (ball_->height_m > 0) {
    fly_on(duration_s);
  } else if (holder_) {
    move_with_holder(robots);
  } else if (time_s - seen_s_ > kGoesOnUnseen_s) {
    motion_.set_velocity(Vec2(0, 0));
  }
  ball_->position_m = motion_.position();
  ball_->velocity_mps = motion_.velocity();
  if (seen) holder_ = holder_among(robots);
  return ball_;
}

void BallTracker::start(const BallObservation& seen) {
  motion_.start(seen.position_m);
  if (!ball_) ball_.emplace();
  kicked_mps_ = 0;
}

// The carpet's deceleration enters the filter as a known acceleration (control input), limited so
// that it cannot reverse the ball.
void BallTracker::predict(double duration_s) {
  const Vec2 velocity_mps = motion_.velocity();
  const double speed_mps = velocity_mps.norm();
  const bool is_on_carpet = ball_->height_m <= 0.0;
  if (speed_mps <= 0.0 || !is_on_carpet) {
    motion_.predict(duration_s, Vec2(0, 0));
    return;
  }
  const bool slides = kicked_mps_ > 0 && speed_mps > kSwitchRatio * kicked_mps_;
  const double slows_mps2 = slides ? kSlide_mps2 : kRoll_mps2;
  const double lost_mps = std::min(slows_mps2 * duration_s, speed_mps);
  motion_.predict(duration_s, velocity_mps * (-lost_mps / (speed_mps * duration_s)));
}

// Extrapolates the flight of an unseen ball ballistically.
void BallTracker::fly_on(double duration_s) {
  ball_->height_m += duration_s * (rise_mps_ - kGravity_mps2 * duration_s / 2);
  rise_mps_ -= kGravity_mps2 * duration_s;
  ball_->height_m = std::max(0.0, ball_->height_m);
}

void BallTracker::correct(const BallObservation& seen, double gap_s) {
  // A flying ball is not at the point on the carpet where the camera sees it.
  if (!seen.height_m && ball_->height_m > 0) return;
  if (!seen.height_m && follows_kick_ && seen.seen_from.position_m != camera_m_) {
    // Another camera projects a flying ball to another point.
    motion_.set_position(seen.position_m);
    return;
  }
  const Vec2 innovation_m = seen.position_m - Vec2(motion_.position());
  if (innovation_m.norm() > kFasterThanAnyBall_mps * gap_s) {
    start(seen);
    follows_kick_ = false;
    ball_->is_height_known = true;
    return;
  }
  const bool exceeds_gate =
      motion_.normalised_innovation_squared(innovation_m) > kBallInnovationGate;
  const Vec2 from_m = ball_->position_m;
  const Vec2 before_mps = motion_.velocity();
  if (exceeds_gate) motion_.inflate_velocity_covariance(gap_s);
  motion_.correct(innovation_m);
  if (!exceeds_gate) return;
  kicked_mps_ = motion_.velocity().norm();
  if (seen.height_m || kicked_mps_ < kSlowestChip_mps) return;
  // A flying ball's apparent path curves slightly. A new kick changes the velocity by more than
  // that curvature does, and its effect persists in the next frame.
  const bool is_known =
      innovation_m.norm() < kNewKick_mps * gap_s || updated_s_ - kick_s_ < 2 * gap_s;
  if (follows_kick_ && is_known) return;
  // For a kick between two detections, halfway is the best estimate of its time.
  kick_s_ = updated_s_ - gap_s / 2;
  chip_.begin(
      {kick_s_, kKickTime * gap_s, from_m, std::max(noise_m_, kKickPosition_m), before_mps});
  follows_kick_ = true;
  kicker_.reset();
}

void BallTracker::follow_kick(const BallObservation& seen, double time_s,
                              const PerSide<TrackedRobots>& robots) {
  if (!follows_kick_) return;
  if (!kicker_) kicker_ = nearest_robot(seen.position_m, robots);
  if (kicker_ && time_s - kick_s_ > kLeavesRobot_s && is_at_kicker(seen.position_m, robots)) {
    // A chipped ball would have left its kicker, so the robot is dribbling or pushing the ball
    // instead.
    if (ball_->height_m > 0) start(seen);
    ball_->height_m = ball_->height_deviation_m = 0;
    follows_kick_ = false;
    ball_->is_height_known = true;
    return;
  }
  const CameraPosition& camera = seen.seen_from;
  const ChipEstimate& flight = chip_.add(
      {time_s, seen.position_m, camera.position_m, std::max(camera.height_m - kBallRadius_m, 1.0)});
  const bool was_flying = ball_->height_m > 0;
  ball_->height_m = 0;
  ball_->height_deviation_m = 0;
  ball_->is_height_known = flight.flight != BallFlight::kUnknown;
  if (flight.flight == BallFlight::kFlying) {
    take_over(flight);
  } else if (was_flying) {
    start(seen);  // the ball has landed or hit something
  }
  if (flight.flight == BallFlight::kOnGround || time_s - kick_s_ > kLongestKick_s) {
    follows_kick_ = false;
    ball_->is_height_known = true;
  }
}

bool BallTracker::is_at_kicker(const Vec2& ball_m, const PerSide<TrackedRobots>& robots) const {
  const double gap_m = kBallRadius_m + kAtHull_m + 2 * noise_m_;
  for (const TrackedRobot& robot : robots[kicker_->side]) {
    if (robot.number != kicker_->number) continue;
    return (robot.position_m - ball_m).squaredNorm() < square(kRobotRadius_m + gap_m) &&
           distance_to_hull(ball_m, robot.position_m, robot.heading) < gap_m;
  }
  return false;
}

void BallTracker::take_over(const ChipEstimate& flight) {
  motion_.set_position(flight.position_m);
  motion_.set_velocity(flight.velocity_mps);
  rise_mps_ = flight.vertical_speed_mps;
  ball_->height_m = std::max(flight.height_m, kLeastFlight_m);
  ball_->height_deviation_m = flight.height_deviation_m;
}

// Rigid-body motion: the ball stays where it is in the robot's frame, with velocity v + omega x r.
void BallTracker::move_with_holder(const PerSide<TrackedRobots>& robots) {
  for (const TrackedRobot& robot : robots[holder_->robot.side]) {
    if (robot.number != holder_->robot.number) continue;
    const Vec2 arm_m = to_world(holder_->position_m, robot.heading);
    motion_.set_position(robot.position_m + arm_m);
    motion_.set_velocity(robot.velocity_mps + robot.angular_velocity_radps * left_of(arm_m));
    return;
  }
}

std::optional<BallTracker::Holder> BallTracker::holder_among(
    const PerSide<TrackedRobots>& robots) const {
  if (ball_->height_m > kBallRadius_m) return std::nullopt;
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : robots[side]) {
      const Vec2 arm_m = ball_->position_m - robot.position_m;
      if (arm_m.squaredNorm() > 4 * kRobotRadius_m * kRobotRadius_m) continue;
      const Vec2 position_m = to_local(arm_m, robot.heading);
      if (position_m.x() > kFrontDistance_m &&
          position_m.x() <= kFrontDistance_m + kBallRadius_m + kAtFront_m &&
          std::abs(position_m.y()) <= kDribblerZoneWidth_m / 2) {
        return Holder{{side, robot.number}, position_m};
      }
    }
  }
  return std::nullopt;
}

}  // namespace autoref::tracking
