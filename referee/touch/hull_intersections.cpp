#include "referee/touch/hull_intersections.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/touch_candidates.hpp"
#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kAnySpeed_mps = 4.0;  // prior standard deviation of an unknown velocity
constexpr double kMillimetre2 = 1e-6;

// The series of 2 artanh(z), accurate to 1e-7. It is used because the last bit of the C library's
// logarithm differs between machines.
double natural_log(double x) {
  constexpr double kLog2 = 0.69314718055994531;
  int exponent = 0;
  const double part = std::frexp(x, &exponent);  // from 0.5 to 1
  const double z = (part - 0.75) / (part + 0.75);
  constexpr double kLogOfThreeQuarters = -0.28768207245178090;
  const double z2 = z * z;
  const double series = 1 + z2 * (1.0 / 3 + z2 * (1.0 / 5 + z2 * (1.0 / 7)));
  return exponent * kLog2 + kLogOfThreeQuarters + 2 * z * series;
}

constexpr double kPathNear_m = 0.3;  // robots farther from the path are skipped
constexpr int kPathSamples = 16;     // number of samples between two frames
constexpr int kSamplesUnseen = 6;

struct Sample {
  Vec2 ball_m{0, 0};
  double time_s = 0;
  double variance_m2 = 0;  // variance of the gap to a hull
};

struct PathPose {
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
};

class Walker {
 public:
  Walker(const BallMotionFilter& motion, bool goes_back,
         const HullIntersectionParameters& parameters)
      : motion_(motion), goes_back_(goes_back), parameters_(parameters) {}

  // Samples the path from one frame to the next; an end point shared by two intervals is sampled
  // once.
  void go(const StoredFrame& from, const StoredFrame& to, int samples, double start_s,
          bool is_first) {
    find_near_robots(from, to);
    for (int i = is_first ? 0 : 1; i <= samples; ++i) {
      const double share = static_cast<double>(i) / samples;
      const double time_s = from.time_s + (to.time_s - from.time_s) * share;
      look(share, sample_at(time_s, start_s));
    }
  }

  const Walk& walk() const { return walk_; }

 private:
  Sample sample_at(double time_s, double start_s) const {
    const double gap_m2 = square(parameters_.contact_m) + square(parameters_.robot_m);
    return {motion_.position_after(time_s - start_s), time_s,
            gap_m2 + motion_.position_variance_after(time_s - start_s)};
  }

  // A robot that is near the ball in the frame `from`, and the same robot in the frame `to`, or
  // null if it is not near the ball in that frame.
  struct NearRobot {
    RobotId id;
    const RobotObservation* from;
    const RobotObservation* to;
  };

  void find_near_robots(const StoredFrame& from, const StoredFrame& to) {
    near_robots_.clear();
    for (const Side side : kSides) {
      for (const RobotObservation& robot : from.robots[side]) {
        if (!is_near_ball(from, robot)) continue;
        const RobotObservation* other = find_robot(to.robots[side], robot.number);
        if (other != nullptr && !is_near_ball(to, *other)) other = nullptr;
        near_robots_.push_back({{side, robot.number}, &robot, other});
      }
    }
  }

  void look(double share, const Sample& sample) {
    double through_deviance = walk_.through_deviance;
    for (const NearRobot& robot : near_robots_) {
      if ((robot.from->position_m - sample.ball_m).squaredNorm() > square(kPathNear_m)) continue;
      through_deviance = std::max(through_deviance, weigh(robot.id, pose_of(robot, share), sample));
    }
    walk_.through_deviance = through_deviance;
  }

  // Weighs a touch by the robot, and returns the deviance of passing through its hull.
  double weigh(RobotId id, const PathPose& pose, const Sample& sample) {
    const double gap_m =
        distance_to_hull(sample.ball_m, pose.position_m, pose.heading) - kBallRadius_m;
    HullIntersection* intersection = intersection_with(id, gap_m);
    if (intersection == nullptr) return 0;
    weigh(*intersection, pose, gap_m, sample);
    const double inside_m = std::max(0.0, -gap_m - parameters_.slack_m);
    return square(inside_m) / sample.variance_m2;
  }

  static PathPose pose_of(const NearRobot& robot, double share) {
    const RobotObservation& from = *robot.from;
    if (robot.to == nullptr) return {from.position_m, from.heading};
    const Vec2 heading = from.heading + (robot.to->heading - from.heading) * share;
    return {from.position_m + (robot.to->position_m - from.position_m) * share,
            direction_of(heading, from.heading)};
  }

  HullIntersection* intersection_with(RobotId id, double gap_m) {
    HullIntersections& intersections = walk_.intersections;
    for (std::size_t i = 0; i < intersections.size(); ++i) {
      if (intersections[i].robot == id) return &intersections[i];
    }
    if (intersections.size() == intersections.capacity()) return nullptr;
    HullIntersection intersection;
    intersection.robot = id;
    intersections.push_back(intersection);
    former_gaps_m_.push_back(gap_m);
    return &intersections.back();
  }

  void weigh(HullIntersection& intersection, const PathPose& pose, double gap_m,
             const Sample& sample) {
    double& former_gap_m =
        former_gaps_m_[static_cast<std::size_t>(&intersection - &walk_.intersections[0])];
    const bool crosses = (gap_m > 0) != (former_gap_m > 0);
    former_gap_m = gap_m;
    intersection.least_gap_m = std::min(intersection.least_gap_m, gap_m);
    const double least = std::min(intersection.bounce_deviance, intersection.kick_deviance);
    const double off_m = crosses ? 0 : std::max(0.0, std::abs(gap_m) - parameters_.slack_m);
    const double bounce_deviance = walk_.through_deviance + square(off_m) / sample.variance_m2;
    const double kick_deviance = walk_.through_deviance + kick_deviance_of(pose, sample);
    intersection.bounce_deviance = std::min(intersection.bounce_deviance, bounce_deviance);
    intersection.kick_deviance = std::min(intersection.kick_deviance, kick_deviance);
    if (std::min(bounce_deviance, kick_deviance) >= least) return;
    intersection.time_s = sample.time_s;
    intersection.gap_m = std::max(0.0, gap_m);
  }

  double kick_deviance_of(const PathPose& pose, const Sample& sample) const {
    const Vec2 local_m = to_local(sample.ball_m - pose.position_m, pose.heading);
    const double off_m = 3 * std::sqrt(sample.variance_m2);
    const double before_m = local_m.x() - kFrontDistance_m - kBallRadius_m;
    const bool in_dribbler_zone = local_m.x() > kFrontDistance_m - 5_mm &&
                                  before_m <= parameters_.reach_m + off_m &&
                                  std::abs(local_m.y()) <= kDribblerZoneWidth_m / 2 + off_m;
    if (!in_dribbler_zone) return kNever;
    if (!goes_back_) return 0;
    const Vec2 along_mps = to_local(motion_.velocity_mps(), pose.heading);
    const double angle_variance = square(parameters_.kick_rad) + square(parameters_.robot_rad);
    const double variance =
        angle_variance * along_mps.squaredNorm() + motion_.velocity_variance_m2ps2();
    return (square(along_mps.y()) + square(std::min(0.0, along_mps.x()))) / variance;
  }

  const BallMotionFilter& motion_;
  bool goes_back_;
  const HullIntersectionParameters& parameters_;
  Walk walk_;
  boost::container::static_vector<NearRobot, 2 * kMaxRobots> near_robots_;
  boost::container::static_vector<double, HullIntersections::static_capacity> former_gaps_m_;
};

}  // namespace

void BallMotionFilter::start(const Vec2& seen_m, const BallMotionParameters& parameters) {
  *this = BallMotionFilter{};
  position_m_ = seen_m;
  pp_ = square(parameters.detection_m);
  vv_ = square(kAnySpeed_mps);
  aa_ = square(parameters.slides_mps2);
}

void BallMotionFilter::jump(const Vec2& seen_m, const BallMotionParameters& parameters) {
  start(seen_m, parameters);
  pp_ = square(parameters.jump_m);
}

void BallMotionFilter::predict(double duration_s, const BallMotionParameters& parameters) {
  const double t = duration_s;
  const double h = t * t / 2;
  position_m_ += t * velocity_mps_ + h * acceleration_mps2_;
  velocity_mps_ += t * acceleration_mps2_;
  pp_ += 2 * (t * pv_ + h * pa_ + t * h * va_) + t * t * vv_ + h * h * aa_;
  pv_ += t * (pa_ + vv_) + 3 * h * va_ + t * h * aa_;
  pa_ += t * va_ + h * aa_;
  vv_ += 2 * t * va_ + t * t * aa_;
  va_ += t * aa_;
  // White-noise jerk, discretised to first order in the step.
  aa_ += (rolls_ ? parameters.rolls_change_m2ps5 : parameters.slides_change_m2ps5) * std::abs(t);
  if (rolls_ && t > 0 && velocity_mps_.dot(acceleration_mps2_) > 0) {
    velocity_mps_ = acceleration_mps2_ = Vec2(0, 0);  // friction has stopped the ball
  }
}

void BallMotionFilter::touch(double duration_s, bool is_soft,
                             const BallMotionParameters& parameters) {
  // A velocity jump at a time uniformly distributed over the interval.
  const double variance = square(is_soft ? parameters.soft_mps : parameters.hard_mps);
  pp_ += variance * square(duration_s) / 3;
  pv_ += variance * duration_s / 2;
  vv_ += variance;
  if (is_soft) {
    begin_to_roll(parameters);
    return;
  }
  rolls_ = false;
  acceleration_mps2_ = Vec2(0, 0);
  pa_ = va_ = 0;
  aa_ = square(parameters.slides_mps2);
}

void BallMotionFilter::begin_to_roll(const BallMotionParameters& parameters) {
  rolls_ = true;
  acceleration_mps2_ = -parameters.rolls_mps2 * direction_of(velocity_mps_, Vec2(0, 0));
  pa_ = va_ = 0;
  aa_ = square(parameters.rolls_off_mps2);
  vv_ += square(parameters.begins_to_roll_mps);
}

double BallMotionFilter::correct(const Vec2& seen_m, const BallMotionParameters& parameters) {
  const Vec2 innovation_m = seen_m - position_m_;
  const double variance = pp_ + square(parameters.detection_m);
  const double position_gain = pp_ / variance;
  const double velocity_gain = pv_ / variance;
  const double acceleration_gain = pa_ / variance;
  position_m_ += position_gain * innovation_m;
  velocity_mps_ += velocity_gain * innovation_m;
  acceleration_mps2_ += acceleration_gain * innovation_m;
  aa_ -= acceleration_gain * pa_;
  va_ -= velocity_gain * pa_;
  vv_ -= velocity_gain * pv_;
  pa_ -= position_gain * pa_;
  pv_ -= position_gain * pv_;
  pp_ -= position_gain * pp_;
  return innovation_m.squaredNorm() / variance + 2 * natural_log(variance / kMillimetre2);
}

Vec2 BallMotionFilter::position_after(double duration_s) const {
  return position_m_ + duration_s * velocity_mps_ + square(duration_s) / 2 * acceleration_mps2_;
}

double BallMotionFilter::position_variance_after(double duration_s) const {
  return std::max(0.0, pp_ + 2 * duration_s * pv_ + square(duration_s) * vv_);
}

Walk walk(const BallMotionFilter& motion, const FrameHistory& frame_history, std::int64_t from,
          std::int64_t to, const HullIntersectionParameters& parameters) {
  const int step = to > from ? 1 : -1;
  const int samples = from + step == to ? kPathSamples : kSamplesUnseen;
  Walker walker(motion, step < 0, parameters);
  for (std::int64_t i = from; i != to; i += step) {
    walker.go(frame_history[i], frame_history[i + step], samples, frame_history[from].time_s,
              i == from);
  }
  return walker.walk();
}

}  // namespace autoref::referee
