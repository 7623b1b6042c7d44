#include "soccer/ball_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref {
namespace {

// Between the carpets of the league's simulators.
constexpr double kSlide_mps2 = 3.4;
constexpr double kRoll_mps2 = 0.3;
constexpr double kSwitchRatio = 0.67;

constexpr double kLeastNoise_m = 0.05e-3;
constexpr double kUnsteady_m2ps3 = 0.1;
constexpr double kAnySpeed_mps = 8.0;
// Two axes: a right filter is surprised by more once in 3000 sightings.
constexpr double kSurprise = 16.0;
constexpr double kFasterThanAnyBall_mps = 25.0;  // the ball was set elsewhere
constexpr double kAtFront_m = 15_mm;             // between the ball's surface and the plate

}  // namespace

BallTracker::BallTracker(double noise_m)
    : motion_({std::max(noise_m, kLeastNoise_m), kUnsteady_m2ps3, kAnySpeed_mps}) {}

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
    if (seen) correct(*seen, duration_s);
  }
  if (seen) {
    seen_s_ = time_s;
    ball_->height_m = seen->height_m.value_or(0.0);
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
  ball_.emplace();
  kicked_mps_ = 0;
}

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

void BallTracker::correct(const BallObservation& seen, double duration_s) {
  const Vec2 miss_m = seen.position_m - Vec2(motion_.position());
  if (miss_m.norm() > kFasterThanAnyBall_mps * duration_s) {
    start(seen);
    return;
  }
  const bool is_surprise = motion_.surprise(miss_m) > kSurprise;
  if (is_surprise) motion_.doubt_velocity(duration_s);
  motion_.correct(miss_m);
  if (is_surprise) kicked_mps_ = motion_.velocity().norm();
}

void BallTracker::move_with_holder(const PerSide<TrackedRobots>& robots) {
  for (const TrackedRobot& robot : robots[holder_->robot.side]) {
    if (robot.number != holder_->robot.number) continue;
    const Vec2 arm_m = to_world(holder_->place_m, robot.heading);
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
      const Vec2 place_m = to_local(arm_m, robot.heading);
      if (place_m.x() > kFrontDistance_m &&
          place_m.x() <= kFrontDistance_m + kBallRadius_m + kAtFront_m &&
          std::abs(place_m.y()) <= kMouthWidth_m / 2) {
        return Holder{{side, robot.number}, place_m};
      }
    }
  }
  return std::nullopt;
}

}  // namespace autoref
