#include "strategies/skills/ball_path.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::strategies {
namespace {

constexpr double kSlide_mps2 = 3.4;
constexpr double kRoll_mps2 = 0.30;
constexpr double kRollsFrom = 0.67;  // fraction of the kick speed at which the ball begins to roll
constexpr double kPathStill_mps = 0.03;
constexpr double kPeak_mps = 0.15;  // speed gain per frame that indicates a kick
constexpr double kNever_s = 10;

// Duration and length of the sliding phase from `speed_mps` down to `rolls_mps`.
struct Phase {
  double time_s = 0;
  double path_m = 0;
};
Phase sliding(double speed_mps, double rolls_mps) {
  const double time_s = std::max(0.0, (speed_mps - rolls_mps) / kSlide_mps2);
  return {time_s, time_s * (speed_mps + rolls_mps) / 2};
}

double rolled_m(double speed_mps, double time_s) {
  const double t = std::min(time_s, speed_mps / kRoll_mps2);
  return speed_mps * t - kRoll_mps2 * t * t / 2;
}

// `slide` is the phase from `speed_mps` down to `rolling_mps`.
double path_after_m(double speed_mps, double rolling_mps, const Phase& slide, double time_s) {
  if (time_s < slide.time_s) return speed_mps * time_s - kSlide_mps2 * time_s * time_s / 2;
  return slide.path_m + rolled_m(rolling_mps, time_s - slide.time_s);
}

double speed_after_mps(double speed_mps, double rolling_mps, const Phase& slide, double time_s) {
  if (time_s < slide.time_s) return speed_mps - kSlide_mps2 * time_s;
  return std::max(0.0, rolling_mps - kRoll_mps2 * (time_s - slide.time_s));
}

constexpr double kUsableBraking = 0.75;  // usable fraction of the robot's braking; the wheels do
                                         // not allow more
constexpr double kReachTouch_m = kFrontDistance_m + kBallRadius_m;
constexpr double kReachMargin_m = 2e-6;  // far above rounding errors
// Distance outside the field at which a robot can still save a ball.
constexpr double kBeyond_m = 100_mm;

// Time in seconds to travel `distance_m` along a line and stop, starting at the speed `along_mps`,
// with a trapezoidal velocity profile.
double line_time_s(double distance_m, double along_mps, const Abilities& a) {
  const double brake_mps2 = kUsableBraking * a.braking_mps2;
  if (along_mps < 0) {  // the robot must stop first and then drive farther
    const double stop_s = -along_mps / brake_mps2;
    return stop_s + line_time_s(distance_m - along_mps * stop_s / 2, 0, a);
  }
  const double speed2 = along_mps * along_mps;
  // Triangular profile: (peak^2 - v^2) / (2 a) + peak^2 / (2 b) = distance, with acceleration a and
  // braking b.
  const double peak2 =
      (2 * distance_m + speed2 / a.acceleration_mps2) / (1 / a.acceleration_mps2 + 1 / brake_mps2);
  if (peak2 <= speed2)
    return 2 * distance_m / std::max(0.1, along_mps);  // the robot overshoots a little
  const double top_mps = std::max(a.speed_mps, along_mps);
  if (peak2 <= top_mps * top_mps) {
    const double peak_mps = std::sqrt(peak2);
    return (peak_mps - along_mps) / a.acceleration_mps2 + peak_mps / brake_mps2;
  }
  const double ramps_m = (top_mps * top_mps - speed2) / (2 * a.acceleration_mps2) +
                         top_mps * top_mps / (2 * brake_mps2);
  return (top_mps - along_mps) / a.acceleration_mps2 + top_mps / brake_mps2 +
         (distance_m - ramps_m) / top_mps;
}

// The longest distance that a robot can travel along a line within a given time, in any direction.
// This is the inverse of line_time_s(), starting at the robot's full speed.
class FarthestReach {
 public:
  FarthestReach(double speed_mps, const Abilities& a)
      : start_mps_(speed_mps),
        start_s_(speed_mps / a.acceleration_mps2),
        top_mps_(std::max(a.speed_mps, speed_mps)),
        per_mps_s_(1 / a.acceleration_mps2 + 1 / (kUsableBraking * a.braking_mps2)),
        start_m_(speed_mps * start_s_ / 2) {}

  double within_m(double time_s) const {
    const double peak_mps = (time_s + start_s_) / per_mps_s_;
    if (peak_mps <= start_mps_) return std::max(0.1, start_mps_) * time_s / 2;
    const double capped_mps = std::min(peak_mps, top_mps_);
    const double ramps_s = capped_mps * per_mps_s_;
    return capped_mps * ramps_s / 2 - start_m_ + top_mps_ * (time_s + start_s_ - ramps_s);
  }

 private:
  double start_mps_;
  double start_s_;
  double top_mps_;
  double per_mps_s_;  // time per unit of speed for accelerating and braking
  double start_m_;    // path on which the robot accelerates to its speed
};

// Time until the robot can touch the ball at the given step of the ball's path.
double time_to_touch_s(const TrackedRobot& robot, const BallPath& path, int step,
                       const Abilities& abilities) {
  const Vec2& ball_m = path.at_step(step);
  const Vec2 to_robot = direction_of(robot.position_m - ball_m, Vec2(-1, 0));
  return time_to_s(robot, ball_m + to_robot * kReachTouch_m, abilities);
}

}  // namespace

void BallPath::follow(const TrackedBall& ball, double latency_s) {
  const double seen_mps = ball.velocity_mps.norm();
  // The kick speed determines when sliding ends. A jump in speed means a new kick. Once the ball
  // rolls, kick_mps_ shrinks with the ball's speed, so that a softer kick is also detected.
  if (seen_mps > last_mps_ + kPeak_mps || seen_mps > kick_mps_) kick_mps_ = seen_mps;
  if (seen_mps < kRollsFrom * kick_mps_) kick_mps_ = seen_mps / kRollsFrom;  // the ball is rolling
  last_mps_ = seen_mps;
  direction_ = direction_of(ball.velocity_mps, direction_);
  const double rolling_mps = std::min(seen_mps, kRollsFrom * kick_mps_);
  const Phase slide = sliding(seen_mps, rolling_mps);
  const bool is_still = seen_mps < kPathStill_mps;
  speed_mps_ = is_still ? 0 : speed_after_mps(seen_mps, rolling_mps, slide, latency_s);
  for (int i = 0; i <= kSteps; ++i) {
    const double path_m =
        is_still ? 0 : path_after_m(seen_mps, rolling_mps, slide, latency_s + i * kStep_s);
    table_[static_cast<std::size_t>(i)] = ball.position_m + direction_ * path_m;
  }
}

double kick_for_mps(double distance_m, double arrival_mps) {
  // If the ball arrives rolling: v_roll^2 = arrival^2 + 2 a (distance - slide), slide = k v0^2.
  constexpr double kSlidePerSpeed2 = (1 - kRollsFrom * kRollsFrom) / (2 * kSlide_mps2);
  constexpr double kShare = kRollsFrom * kRollsFrom + 2 * kRoll_mps2 * kSlidePerSpeed2;
  const double kick2 = (arrival_mps * arrival_mps + 2 * kRoll_mps2 * distance_m) / kShare;
  if (kSlidePerSpeed2 * kick2 <= distance_m) return std::sqrt(kick2);
  // The ball arrives sliding.
  return std::sqrt(arrival_mps * arrival_mps + 2 * kSlide_mps2 * distance_m);
}

KickedBall::KickedBall(double kick_mps) : kick_mps_(kick_mps), rolls_mps_(kRollsFrom * kick_mps) {
  const Phase slide = sliding(kick_mps, rolls_mps_);
  slide_s_ = slide.time_s;
  slide_m_ = slide.path_m;
}

// Solves s = v t - a t^2 / 2 for t in the phase in which the ball covers the distance.
double KickedBall::roll_time_s(double distance_m) const {
  if (distance_m <= slide_m_) {
    const double left2 = kick_mps_ * kick_mps_ - 2 * kSlide_mps2 * distance_m;
    return (kick_mps_ - std::sqrt(std::max(0.0, left2))) / kSlide_mps2;
  }
  const double left2 = rolls_mps_ * rolls_mps_ - 2 * kRoll_mps2 * (distance_m - slide_m_);
  if (left2 < 0) return kNever_s;
  return slide_s_ + (rolls_mps_ - std::sqrt(left2)) / kRoll_mps2;
}

double time_to_s(const TrackedRobot& robot, const Vec2& point_m, const Abilities& abilities) {
  const Vec2 offset = point_m - robot.position_m;
  const double distance_m = offset.norm();
  if (distance_m < 1e-6) return robot.velocity_mps.norm() / abilities.braking_mps2;
  const Vec2 direction = offset / distance_m;
  const double along_mps = robot.velocity_mps.dot(direction);
  const double aside_mps = std::abs(cross(direction, robot.velocity_mps));
  // Lateral velocity is braked on the way, which costs about half as much as braking it separately.
  return line_time_s(distance_m, along_mps, abilities) + 0.5 * aside_mps / abilities.braking_mps2;
}

// Steps along the ball's predicted path to the first step that the robot reaches no later than the
// ball, and interpolates linearly between that step and the previous one.
BallInterception intercept(const TrackedRobot& robot, const BallPath& path,
                           const Abilities& abilities, const Field& field) {
  const double x_m = field.half_length_m() + kBeyond_m;
  const double y_m = field.half_width_m() + kBeyond_m;
  if (path.speed_mps() <= 0) return {path.now_m(), time_to_touch_s(robot, path, 0, abilities)};
  const int stride = path.speed_mps() < 0.5 ? 4 : 2;
  const FarthestReach reach(robot.velocity_mps.norm(), abilities);
  int last = 0;
  for (int step = 0; step <= BallPath::kSteps; step += stride) {
    const Vec2& ball_m = path.at_step(step);
    if (step > 0 && (std::abs(ball_m.x()) > x_m || std::abs(ball_m.y()) > y_m)) break;
    last = step;
    const double ball_s = step * BallPath::kStep_s;
    // The point is out of reach even if the robot were already moving towards it.
    const double touch_m = reach.within_m(ball_s) + kReachTouch_m + kReachMargin_m;
    if ((robot.position_m - ball_m).squaredNorm() > touch_m * touch_m) continue;
    const double late_s = time_to_touch_s(robot, path, step, abilities) - ball_s;
    if (late_s > 0) continue;
    if (step == 0) return {ball_m, 0};
    // Interpolates between this step and the previous one.
    const Vec2& before_m = path.at_step(step - stride);
    const double before_late_s = time_to_touch_s(robot, path, step - stride, abilities) -
                                 (step - stride) * BallPath::kStep_s;
    const double share = before_late_s / (before_late_s - late_s);
    return {before_m + share * (ball_m - before_m),
            ball_s - (1 - share) * stride * BallPath::kStep_s};
  }
  return {path.at_step(last), time_to_touch_s(robot, path, last, abilities)};
}

}  // namespace autoref::strategies
