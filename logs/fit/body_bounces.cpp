#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "logs/fit/bounces.hpp"
#include "soccer/parameters.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kBodyContact_m = kRobotRadius_m + kBallRadius_m;
constexpr double kNearBody_m = 0.16;
constexpr std::size_t kPassGap_frames = 3;
constexpr double kLongestPass_s = 0.25;  // longer ones are held or pushed balls
constexpr std::size_t kMostBodySights = 9;
constexpr std::size_t kBeforePass_frames = 9;
constexpr std::size_t kAfterPass_frames = 13;
constexpr std::size_t kRobotSights_frames = 6;  // of the robot, before and after the pass
constexpr std::size_t kOthersAway_frames = 4;
constexpr double kBeforeContact_m = 4_mm;
constexpr double kAfterContact_s = 4_ms;
constexpr double kLongestBefore_s = 0.2;
constexpr double kLongestUnseenAtBody_s = 80_ms;
constexpr double kBodyUneven_m = 1_mm;       // errors of vision that noise does not show
constexpr double kContactError_m = 4_mm;     // of the extrapolated contact
constexpr double kWorstBeforeBody = 3.0;     // residual in standard deviations, plus:
constexpr double kWorstBeforeBody_m = 2_mm;  // for a fresh kick, which still slows
constexpr double kWorstAfterBody = 5.0;      // mean squared residual
constexpr double kSlowestIntoBody_mps = 0.8;
constexpr double kFront_rad = 42_deg;  // the plate, and the ball's radius beside it
// Least part of the contact distance that the path, continued, would cut through on the way to the
// point closest to the centre: grazing contacts depend too much on the noise.
constexpr double kHeadOn = 0.35;
constexpr Range kPlausibleRestitution = {-0.1, 1.1};
// After the bounce, the ball slides until its speed and spin agree. They differ by the closing
// speed times this: restitution 0.55, and the spin into the body that friction in the contact
// leaves.
constexpr double kSlipAfterBody = 0.84;

// The ball close to a robot for a moment. Times count from `zero_s`.
struct Pass {
  const RecordedMotion& motion;
  std::size_t robot;
  Stretch near;
  double zero_s;
  double noise_m;

  const RobotSight& robot_in(std::size_t frame) const { return motion.robots[robot].sights[frame]; }
  double distance_m(std::size_t frame) const {
    return (motion.ball[frame].position_m - robot_in(frame).position_m).norm();
  }
  void add_ball(std::size_t frame, Points& points) const {
    points.add(motion.ball[frame].time_s - zero_s, motion.ball[frame].position_m, noise_m);
  }
};

bool is_near_another(const Pass& pass) {
  for (std::size_t other = 0; other < pass.motion.robots.size(); ++other) {
    if (other == pass.robot) continue;
    for (std::size_t f = pass.near.first - kOthersAway_frames;
         f <= pass.near.last + kOthersAway_frames; ++f) {
      const RobotSight& sight = pass.motion.robots[other].sights[f];
      if (sight.is_known &&
          (sight.position_m - pass.motion.ball[f].position_m).norm() < kNearBody_m)
        return true;
    }
  }
  return false;
}

std::optional<Line> path_to_body(const Pass& pass) {
  std::size_t closest = pass.near.first;
  for (std::size_t f = pass.near.first; f <= pass.near.last; ++f)
    if (pass.distance_m(f) < pass.distance_m(closest)) closest = f;
  Points points;
  const std::size_t earliest = pass.near.first - kBeforePass_frames;
  for (std::size_t f = closest + 1; f-- > earliest && points.size() < kMostBodySights;)
    if (pass.motion.ball[f].is_seen && pass.distance_m(f) > kBodyContact_m + kBeforeContact_m)
      pass.add_ball(f, points);
  if (points.size() < kLeastBounceSights ||
      points.times_s.front() - points.times_s.back() > kLongestBefore_s)
    return std::nullopt;
  const Line line = straight_line_through(points);
  if (line.residual <= kWorstBeforeBody + kWorstBeforeBody_m / pass.noise_m) return line;
  return std::nullopt;
}

std::optional<Line> path_of_robot(const Pass& pass) {
  Points points;
  for (std::size_t f = pass.near.first - kRobotSights_frames;
       f <= pass.near.last + kRobotSights_frames; ++f)
    if (pass.robot_in(f).is_seen)
      points.add(pass.motion.times_s[f] - pass.zero_s, pass.robot_in(f).position_m, pass.noise_m);
  if (points.size() < kRobotSights_frames) return std::nullopt;
  return straight_line_through(points);
}

// Where a ball on a straight path meets a robot's hull.
struct BodyContact {
  double time_s = 0;
  Vec2 normal{1, 0};  // out of the robot
  double closing_mps = 0;
};

std::optional<BodyContact> contact_of(const Line& ball, const Line& robot) {
  const Vec2 offset_m = ball.position_m - robot.position_m;
  const Vec2 velocity_mps = ball.velocity_mps - robot.velocity_mps;
  const double speed2 = velocity_mps.squaredNorm();
  const double approach = offset_m.dot(velocity_mps);
  const double root2 =
      square(approach) - speed2 * (offset_m.squaredNorm() - square(kBodyContact_m));
  if (root2 <= square(kHeadOn * kBodyContact_m) * speed2) return std::nullopt;
  const double time_s = (-approach - std::sqrt(root2)) / speed2;
  const Vec2 normal = (offset_m + time_s * velocity_mps) / kBodyContact_m;
  return BodyContact{time_s, normal, -velocity_mps.dot(normal)};
}

bool is_on_front(const Pass& pass, const BodyContact& contact) {
  const RobotSight sight = pass.motion.robot_at(pass.robot, pass.zero_s + contact.time_s);
  return std::abs(angle_between(heading_of(sight.heading_rad), contact.normal)) < kFront_rad;
}

// The path of the ball after the contact, as it would be without sliding; times count from the
// contact, whose position is one of the fitted points.
std::optional<Line> path_from_body(const Pass& pass, const BodyContact& contact,
                                   const Vec2& contact_m, const sim::BallParameters& ball) {
  Points points;
  const double sliding_s =
      kSlipAfterBody * contact.closing_mps * (1 - ball.switch_ratio) / ball.slide_mps2;
  const std::size_t end = std::min(pass.near.last + kAfterPass_frames + 1, pass.motion.frames());
  for (std::size_t f = pass.near.first; f < end && points.size() < kMostBodySights; ++f) {
    const BallSight& sight = pass.motion.ball[f];
    const double since_s = sight.time_s - pass.zero_s - contact.time_s;
    if (!sight.is_seen || since_s <= kAfterContact_s) continue;
    const double slid_s = std::min(since_s, sliding_s);
    const double lost_m = ball.slide_mps2 * slid_s * (since_s - slid_s / 2);
    points.add(since_s, sight.position_m + lost_m * contact.normal, pass.noise_m);
  }
  if (points.size() < kLeastBounceSights || points.times_s[0] > kLongestUnseenAtBody_s)
    return std::nullopt;
  points.add(0, contact_m, kContactError_m);
  const Line line = straight_line_through(points);
  if (square(line.residual) <= kWorstAfterBody) return line;
  return std::nullopt;
}

std::optional<Bounce> body_bounce(const Pass& pass, const sim::BallParameters& ball) {
  const auto before = path_to_body(pass);
  const auto robot = path_of_robot(pass);
  if (!before || !robot) return std::nullopt;
  const auto contact = contact_of(*before, *robot);
  if (!contact || contact->closing_mps < kSlowestIntoBody_mps || is_on_front(pass, *contact))
    return std::nullopt;
  const auto after = path_from_body(pass, *contact, before->at(contact->time_s), ball);
  if (!after) return std::nullopt;
  const double leaving_mps = (after->velocity_mps - robot->velocity_mps).dot(contact->normal);
  const Bounce bounce = bounce_of(contact->closing_mps, leaving_mps);
  if (!kPlausibleRestitution.contains(bounce.restitution)) return std::nullopt;
  return bounce;
}

std::vector<Bounce> body_bounces(const RecordedMotion& motion, std::size_t robot,
                                 const sim::BallParameters& ball) {
  std::vector<Bounce> bounces;
  const auto is_near = [&](std::size_t f) {
    const RobotSight& sight = motion.robots[robot].sights[f];
    return motion.is_running[f] && sight.is_known &&
           (sight.position_m - motion.ball[f].position_m).norm() < kNearBody_m;
  };
  for (const Stretch& near : stretches_of(motion.frames(), kPassGap_frames, is_near)) {
    const double zero_s = motion.times_s[near.first];
    if (motion.times_s[near.last] - zero_s > kLongestPass_s || near.first < kBeforePass_frames ||
        near.last + kAfterPass_frames >= motion.frames())
      continue;
    const Pass pass{motion, robot, near, zero_s, std::hypot(motion.ball_noise_m, kBodyUneven_m)};
    if (is_near_another(pass)) continue;
    if (const auto bounce = body_bounce(pass, ball)) bounces.push_back(*bounce);
  }
  return bounces;
}

}  // namespace

std::vector<Bounce> body_bounces_in(const RecordedMotion& motion, const sim::BallParameters& ball) {
  std::vector<Bounce> bounces;
  for (std::size_t robot = 0; robot < motion.robots.size(); ++robot)
    for (const Bounce& bounce : body_bounces(motion, robot, ball)) bounces.push_back(bounce);
  return bounces;
}

}  // namespace autoref::logs
