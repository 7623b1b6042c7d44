#include "referee/touch/online_touch_detector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// Limits in standard deviations: a position error of up to kMaybe is plausible; a change of more
// than kCertainDeviations is too large to be noise.
constexpr double kMaybe = 3;
constexpr double kCertainDeviations = 5;

}  // namespace

void OnlineTouchDetector::restart() {
  last_ = settled_ = LastTouch{};
  gap_.reset();
  forget_detections();
  changed_s_ = frames_[frames_.newest()].time_s;
  judged_ = frames_.detections();
  known_ = judged_ > 0 ? 1 : 0;
}

void OnlineTouchDetector::forget_detections() {
  known_ = 0;
  is_open_ = false;
  velocity_changes_.restart();
}

void OnlineTouchDetector::update() {
  if (frames_.detections() == judged_) return;
  judged_ = frames_.detections();
  if (ball(0).jumps) forget_detections();
  known_ = std::min(known_ + 1, kUsed);
  if (known_ < 2) return;
  if (gap_) look_back_over_gap();
  if (ball(0).duration_s > parameters_.longest_gap_s) {
    resume_after_gap();
    return;
  }
  detect_sudden_change();
  detect_contacts();
  detect_velocity_change();
  if (!is_open_) settled_ = last_;
}

std::optional<BeforeGap> OnlineTouchDetector::before_gap() const {
  if (frames_.detections() == 0) return std::nullopt;
  return referee::before_gap(frames_, 0, last_, noise_m());
}

// Uses the ball's motion after the gap, unless a robot has touched it since.
void OnlineTouchDetector::look_back_over_gap() {
  if (last_.side) return gap_.reset();
  if (known_ < kDetectionsAtGap) return;
  if (const std::optional<LastTouch> kept = kept_touch(*gap_, frames_)) last_ = settled_ = *kept;
  gap_.reset();
}

// Handles a ball that was unseen for a while: unless the ball moved on as before, a robot touched
// it. That robot is unknown until more of the ball's path has been seen.
void OnlineTouchDetector::resume_after_gap() {
  const BallDetection& now = ball(0);
  const BallDetection& before = frames_[frames_.newest() - 1].ball;
  const Vec2 straight_m = before.position_m + before.velocity_mps * now.duration_s;
  const double slowed_m = parameters_.carpet_mps2 * now.duration_s * now.duration_s / 2;
  const double stopped_m = before.velocity_mps.norm() * now.duration_s;
  const double explained_m = std::min(slowed_m, stopped_m) + parameters_.reach_m;
  const double off_m = (now.position_m - straight_m).norm();
  if (off_m > explained_m) {
    gap_ = referee::before_gap(frames_, 1, last_, noise_m());
    last_ = LastTouch{};
    last_.time_s = now.time_s;
    last_.speed_change_mps = off_m / now.duration_s;
  }
  settled_ = last_;
  forget_detections();
  known_ = 1;
}

bool OnlineTouchDetector::is_sudden_change() const {
  const BallDetection& now = ball(0);
  const BallDetection& before = ball(1);
  const double between_s = (now.duration_s + before.duration_s) / 2;
  // The second difference weights the positions by 1, -2 and 1, so its standard deviation is
  // sqrt(6) times that of the positions.
  const double noise_mps =
      kCertainDeviations * 2.45 * parameters_.position_noise_m / now.duration_s;
  const double explained_mps = parameters_.carpet_mps2 * between_s + parameters_.jump_mps;
  return change_mps(1, 0).norm() > explained_mps + noise_mps && !is_landing();
}

// A landing ball keeps its direction but loses speed, a quarter of it at the first hop.
bool OnlineTouchDetector::is_landing() const {
  const bool in_air =
      ball(0).height_m > 0 || ball(1).height_m > 0 || (known_ > 2 && ball(2).height_m > 0);
  const Vec2& before = ball(1).velocity_mps;
  if (!in_air || before.isZero(0)) return false;
  const Vec2& after = ball(0).velocity_mps;
  const double along = after.dot(before);
  return along <= before.squaredNorm() && along >= 0.4 * before.squaredNorm() &&
         std::abs(cross(before, after)) <= 0.1 * before.squaredNorm();
}

void OnlineTouchDetector::detect_sudden_change() {
  const bool was_open = is_open_;
  is_open_ = false;
  if (!is_sudden_change()) return;
  const std::optional<double> share =
      was_open && known_ > 2 ? share_of_single_touch() : std::nullopt;
  if (share) {
    detect_single_touch(*share);
  } else {
    detect_onwards();
    is_open_ = true;
  }
  changed_s_ = ball(0).time_s;
}

// Two successive velocity changes come from a single touch in between if the mean velocity between
// them is a weighted mean of those before and after. Returns the time of that touch as a fraction
// of the interval, or nullopt.
std::optional<double> OnlineTouchDetector::share_of_single_touch() const {
  const Vec2 jump_mps = change_mps(2, 0);
  const double length2 = jump_mps.squaredNorm();
  if (length2 == 0) return std::nullopt;
  const Vec2 first_mps = change_mps(2, 1);
  const double after = std::clamp(first_mps.dot(jump_mps) / length2, 0.0, 1.0);
  const double duration_s = ball(1).duration_s;
  const double off_m = (first_mps - jump_mps * after).norm() * duration_s;
  const double explained_m = parameters_.carpet_mps2 * duration_s * duration_s +
                             parameters_.intersection_tolerance_m +
                             kMaybe * parameters_.position_noise_m;
  if (off_m > explained_m) return std::nullopt;
  return 1.0 - after;
}

void OnlineTouchDetector::detect_single_touch(double share) {
  const BallDetection& before = ball(2);
  const Vec2 met_m = before.position_m + before.velocity_mps * (share * ball(1).duration_s);
  const BallSegment segment{met_m, met_m, share, share};
  const Verdict verdict = verdict_on(segment, 1, {change_mps(2, 0), ball(0).velocity_mps});
  // If neither a robot nor a goal was near, there was more than one touch, so the first verdict is
  // kept.
  if (!verdict.is_touch && gap_to_goals_m(field_, segment) > parameters_.reach_m) return;
  last_ = settled_;
  conclude(verdict, 1, change_mps(2, 0));
}

// Handles a new velocity change: assumes that the ball moved on as before until a robot touched it.
void OnlineTouchDetector::detect_onwards() {
  const BallDetection& before = ball(1);
  const BallSegment segment{before.position_m,
                            before.position_m + before.velocity_mps * ball(0).duration_s};
  conclude(verdict_on(segment, 0, {change_mps(1, 0), std::nullopt}), 0, change_mps(1, 0));
}

Verdict OnlineTouchDetector::verdict_on(const BallSegment& segment, int interval,
                                        const Impulse& impulse) const {
  const Candidates candidates = candidates_on(segment, frames_.detection(interval + 1),
                                              frames_.detection(interval), impulse, parameters_);
  return attribute_touch(candidates, gap_to_goals_m(field_, segment), last_.side, parameters_);
}

void OnlineTouchDetector::conclude(const Verdict& verdict, int interval, const Vec2& change) {
  if (!verdict.is_touch) return;
  const BallDetection& end = ball(interval);
  const double carpet_mps = parameters_.carpet_mps2 * end.duration_s;
  apply(verdict, end.time_s - (1 - verdict.share) * end.duration_s,
        std::max(0.0, change.norm() - carpet_mps));
}

void OnlineTouchDetector::apply(const Verdict& verdict, double time_s, double speed_change_mps) {
  last_ = {verdict.side, verdict.robot, time_s, verdict.gap_m, speed_change_mps, verdict.runner_up};
}

// A hull that merely passes the ball touches it for a moment; a hull that pushes or carries the
// ball stays at it in all detections used.
bool OnlineTouchDetector::carries_ball(RobotId id) const {
  if (ball(0).velocity_mps.norm() < parameters_.carried_mps) return false;
  // The standard deviation of the difference of two positions is sqrt(2) times that of each
  // position.
  const double moved_m = (ball(0).position_m - ball(kUsed - 1).position_m).norm();
  if (moved_m < kCertainDeviations * 1.41 * parameters_.position_noise_m) return false;
  for (int back = 0; back < kUsed; ++back) {
    const RobotObservation* robot = find_robot(frames_.detection(back).robots[id.side], id.number);
    if (robot == nullptr) return false;
    if (!(gap_to_robot_m(*robot, ball(back).position_m) <= touching_m())) return false;
  }
  return true;
}

// Whether the robot pushed the ball so softly that its velocity did not change suddenly. The hull
// must have touched the ball, and the ball must have accelerated away from the hull. The
// acceleration must be large enough under both possible assumptions about friction. Either friction
// stayed the same as just before, or it ceased because the ball began to roll.
bool OnlineTouchDetector::pushed_softly(const RobotObservation& robot) const {
  if (!(gap_to_robot_m(robot, ball(1).position_m) <= touching_m())) return false;
  const double duration_s = ball(0).duration_s;
  const Vec2 carpet_mps = 2 * clamp_norm(change_mps(3, 2), parameters_.carpet_mps2 * duration_s);
  const Vec2 push = push_direction(robot, ball(1).position_m);
  const double push_mps = change_mps(2, 0).dot(push);
  // Positions are weighted by up to 5, so the standard deviation of the sum is about 8 times that
  // of each position.
  const double noise_mps = kCertainDeviations * 8 * parameters_.position_noise_m / duration_s;
  return std::min(push_mps, push_mps - carpet_mps.dot(push)) >=
         parameters_.soft_push_mps + noise_mps;
}

double OnlineTouchDetector::noise_m() const {
  return std::hypot(parameters_.position_noise_m, robot_noise_m_);
}

double OnlineTouchDetector::touching_m() const {
  return parameters_.touching_m + kMaybe * parameters_.position_noise_m;
}

// Detects, a few frames later, soft touches that are hidden by noise between single frames.
void OnlineTouchDetector::detect_velocity_change() {
  if (parameters_.position_noise_m <= 0) return;
  const std::optional<VelocityChange> change = velocity_changes_.update();
  if (!change || change->since_s <= changed_s_) return;
  const Candidates candidates =
      candidates_on(change->segment, *change->before, *change->after, change->impulse, parameters_);
  const Verdict verdict =
      attribute_touch(candidates, gap_to_goals_m(field_, change->segment), last_.side, parameters_);
  if (!verdict.is_touch) return;
  apply(verdict, change->before->time_s, change->impulse.change_mps.norm());
  settled_ = last_;
}

TouchParameters OnlineTouchDetector::with_noise(TouchParameters parameters,
                                                const tracking::VisionNoise& noise) {
  parameters.position_noise_m = noise.ball_m;
  const double noise_m = kMaybe * noise.ball_m;
  parameters.contact_m += noise_m;
  parameters.reach_m += noise_m;
  parameters.pinned_m += noise_m;
  return parameters;
}

void OnlineTouchDetector::detect_contacts() {
  const StoredFrame& before = frames_.detection(1);
  if (known_ < kUsed || ball(0).height_m > kRobotHeight_m) return;
  const double near_m = kRobotRadius_m + kBallRadius_m + parameters_.pinned_m;
  Candidates at_ball;
  bool is_touch = false;
  for (Side side : kSides) {
    for (const RobotObservation& robot : before.robots[side]) {
      if (!((robot.position_m - before.ball.position_m).squaredNorm() <= near_m * near_m)) continue;
      const double gap_m = gap_to_robot_m(robot, before.ball.position_m);
      if (!(gap_m <= parameters_.pinned_m)) continue;
      at_ball.push_back({{side, robot.number}, std::max(0.0, gap_m), 1, true});
      is_touch = is_touch || pushed_softly(robot) || carries_ball({side, robot.number});
    }
  }
  if (!is_touch) return;
  constexpr double kNoGoalNear_m = std::numeric_limits<double>::infinity();
  conclude(attribute_touch(at_ball, kNoGoalNear_m, last_.side, parameters_), 1, change_mps(1, 0));
  settled_ = last_;
}

}  // namespace autoref::referee
