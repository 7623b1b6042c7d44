#include "referee/touch/touch_candidates.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr int kCandidateSamples = 16;   // per segment; a fast ball moves 8 mm between two samples
constexpr double kNormalStep_m = 1e-4;  // step of the central differences for the normal

struct CandidatePose {
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
};

// A robot's motion between two detections.
class Motion {
 public:
  Motion(const RobotObservation& before, const RobotObservation& after)
      : before_{before.position_m, before.heading}, after_{after.position_m, after.heading} {}

  CandidatePose at(double share) const {
    const Vec2 heading = before_.heading + (after_.heading - before_.heading) * share;
    return {before_.position_m + (after_.position_m - before_.position_m) * share,
            direction_of(heading, after_.heading)};
  }

 private:
  CandidatePose before_;
  CandidatePose after_;
};

double gap_m(const CandidatePose& pose, const Vec2& ball_m) {
  return distance_to_hull(ball_m, pose.position_m, pose.heading) - kBallRadius_m;
}

Vec2 hull_normal(const CandidatePose& pose, const Vec2& ball_m) {
  const Vec2 dx(kNormalStep_m, 0);
  const Vec2 dy(0, kNormalStep_m);
  const Vec2 slope(gap_m(pose, ball_m + dx) - gap_m(pose, ball_m - dx),
                   gap_m(pose, ball_m + dy) - gap_m(pose, ball_m - dy));
  return direction_of(slope, pose.heading);
}

Vec2 on_segment(const BallSegment& segment, double part) {
  return segment.from_m + (segment.to_m - segment.from_m) * part;
}

double share_on(const BallSegment& segment, double part) {
  return segment.from_share + (segment.to_share - segment.from_share) * part;
}

struct Approach {
  double gap_m = 0;
  double part = 0;  // fraction of the segment, from 0 to 1
};

// The first contact on the segment, or the closest approach if there is none.
Approach approach_on(const BallSegment& segment, const Motion& motion) {
  Approach best{gap_m(motion.at(share_on(segment, 0)), on_segment(segment, 0)), 0};
  for (int i = 1; i <= kCandidateSamples && best.gap_m > 0; ++i) {
    const double part = static_cast<double>(i) / kCandidateSamples;
    const double gap = gap_m(motion.at(share_on(segment, part)), on_segment(segment, part));
    if (gap < best.gap_m) best = {gap, part};
  }
  return best;
}

bool is_within(const Vec2& a, const Vec2& b, double cosine) {
  return a.dot(b) >= cosine * a.norm() * b.norm();
}

bool is_in_dribbler_zone(const CandidatePose& pose, const Vec2& ball_m, double reach_m) {
  const Vec2 local = to_local(ball_m - pose.position_m, pose.heading);
  return local.x() > 0 && local.x() - kFrontDistance_m - kBallRadius_m <= reach_m &&
         std::abs(local.y()) <= kDribblerZoneWidth_m / 2 + kBallRadius_m / 2;
}

bool explains(const CandidatePose& pose, const Vec2& ball_m, double gap, const Impulse& impulse,
              const TouchParameters& p) {
  const bool bounced =
      gap <= p.contact_m && is_within(impulse.change_mps, hull_normal(pose, ball_m), p.bounce_cos);
  const bool kicked =
      is_in_dribbler_zone(pose, ball_m, p.reach_m) &&
      (is_within(impulse.change_mps, pose.heading, p.kick_cos) ||
       (impulse.after_mps && is_within(*impulse.after_mps, pose.heading, p.kick_cos)));
  return bounced || kicked;
}

// Whether the robot is too far from the whole segment to reach the ball.
bool is_far(const BallSegment& segment, const RobotObservation& before,
            const RobotObservation& after, double reach_m) {
  const double near_m =
      kRobotRadius_m + kBallRadius_m + reach_m + (after.position_m - before.position_m).norm();
  return !(distance_to_segment(after.position_m, segment.from_m, segment.to_m) <= near_m);
}

double distance_to_box_m(const Vec2& point_m, const Vec2& low_m, const Vec2& high_m) {
  const Vec2 nearest_m(std::clamp(point_m.x(), low_m.x(), high_m.x()),
                       std::clamp(point_m.y(), low_m.y(), high_m.y()));
  return (point_m - nearest_m).norm();
}

constexpr double kTouches_m = 1_mm;
constexpr double kSeparate_m = 20_mm;

}  // namespace

const RobotObservation* find_robot(const SeenRobots& robots, int number) {
  const auto found = std::find_if(robots.begin(), robots.end(),
                                  [number](const auto& robot) { return robot.number == number; });
  return found == robots.end() ? nullptr : &*found;
}

double gap_to_robot_m(const RobotObservation& robot, const Vec2& ball_m) {
  return gap_m({robot.position_m, robot.heading}, ball_m);
}

Vec2 push_direction(const RobotObservation& robot, const Vec2& ball_m) {
  return hull_normal({robot.position_m, robot.heading}, ball_m);
}

Candidates candidates_on(const BallSegment& segment, const StoredFrame& before,
                         const StoredFrame& after, const Impulse& impulse,
                         const TouchParameters& parameters) {
  Candidates found;
  if (std::min(before.ball.height_m, after.ball.height_m) > kRobotHeight_m) return found;
  for (Side side : kSides) {
    for (const RobotObservation& robot : after.robots[side]) {
      const RobotObservation* former = find_robot(before.robots[side], robot.number);
      if (former == nullptr) former = &robot;
      if (is_far(segment, *former, robot, parameters.reach_m)) continue;
      const Motion motion(*former, robot);
      const Approach approach = approach_on(segment, motion);
      if (!(approach.gap_m <= parameters.reach_m)) continue;
      const double share = share_on(segment, approach.part);
      found.push_back({{side, robot.number},
                       std::max(0.0, approach.gap_m),
                       share,
                       explains(motion.at(share), on_segment(segment, approach.part),
                                approach.gap_m, impulse, parameters)});
    }
  }
  return found;
}

double gap_to_goals_m(const Field& field, const BallSegment& segment) {
  // By symmetry, one post represents all four.
  const Vec2 low_m(field.half_length_m(), field.half_goal_m());
  const double length_m =
      field.goal_sides_reach_wall ? field.behind_goal_lines_m() : field.goal_depth_m;
  const Vec2 high_m = low_m + Vec2(length_m, field.goal_wall_thickness_m);
  double least_m = distance_to_box_m(segment.from_m.cwiseAbs(), low_m, high_m);
  for (int i = 1; i <= kCandidateSamples; ++i) {
    const Vec2 ball_m = on_segment(segment, static_cast<double>(i) / kCandidateSamples);
    least_m = std::min(least_m, distance_to_box_m(ball_m.cwiseAbs(), low_m, high_m));
  }
  return std::max(0.0, least_m - kBallRadius_m);
}

bool has_ball(const TrackedRobot& robot, const TrackedBall& ball, bool had,
              const tracking::VisionNoise& noise) {
  if (ball.height_m > kRobotHeight_m) return false;
  const double gap_m =
      distance_to_hull(ball.position_m, robot.position_m, robot.heading) - kBallRadius_m;
  const double noise_m = std::hypot(noise.ball_m, noise.robot_m);
  return gap_m < (had ? kSeparate_m : kTouches_m + noise_m);
}

}  // namespace autoref::referee
