#include "referee/touch/touch_sources.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kFastestRobot_mps = 4.0;  // somewhat more than the league's reach
constexpr double kNearGoal_m = 0.5;        // a ball farther from the goal lines meets no post
// Detections that tell where a way comes from. With more, the carpet and others bend it.
constexpr int kTellingDetections = 8;
// What a landing leaves of the ball's speed along its way, and may add across: as in the running
// detector, 0.75 at the first hop and 0.5 where it began to spin.
constexpr double kLandedAlong = 0.4;
constexpr double kLandedAcross = 0.1;

// From the ball's surface to the robot in that frame; kNever where it is not in it.
double seen_gap_m(const StoredFrame& frame, RobotId id) {
  const RobotObservation* robot = find_robot(frame.robots[id.side], id.number);
  if (robot == nullptr || !is_near_ball(frame, *robot)) return kNever;
  return gap_to_robot_m(*robot, frame.ball.position_m);
}

// The way's first detections, taken in backwards: where and how fast it began.
BallMotionFilter motion_from_start(const TouchHypothesis& hypothesis, std::int64_t now,
                                   const HypothesisContext& basis) {
  const FrameHistory& frame_history = basis.frame_history;
  const BallMotionParameters& parameters = basis.parameters.motion;
  std::int64_t last = hypothesis.start;
  for (int n = 1; n < kTellingDetections && last < now;)
    n += frame_history[++last].has_ball ? 1 : 0;
  while (!frame_history[last].has_ball) --last;
  BallMotionFilter motion;
  motion.start(frame_history[last].ball.position_m, parameters);
  double time_s = frame_history[last].time_s;
  for (std::int64_t i = last - 1; i >= hypothesis.start; --i) {
    if (!frame_history[i].has_ball) continue;
    motion.predict(frame_history[i].time_s - time_s, parameters);
    time_s = frame_history[i].time_s;
    motion.correct(frame_history[i].ball.position_m, parameters);
  }
  return motion;
}

// Whether a ball that nobody touched may go on like this after it landed.
bool goes_on(const TouchHypothesis& hypothesis, const BallMotionFilter& motion, double surely) {
  const Vec2& before_mps = hypothesis.before_mps;
  const double along = motion.velocity_mps().dot(before_mps);
  const double across = cross(motion.velocity_mps(), before_mps);
  const double off_mps = surely * std::sqrt(motion.velocity_variance_m2ps2());
  const double speed_mps = before_mps.norm();
  return along > (kLandedAlong * speed_mps - off_mps) * speed_mps &&
         std::abs(across) <= (kLandedAcross * speed_mps + off_mps) * speed_mps;
}

// A ball that flies may seem to jump, and loses up to half of its speed when it lands.
double nll_without_robot(const TouchHypothesis& hypothesis, const BallMotionFilter& motion,
                         const HypothesisContext& basis) {
  const TouchHypothesisParameters& p = basis.parameters;
  const FrameHistory& frame_history = basis.frame_history;
  const bool in_air = std::max(frame_history[hypothesis.start].ball.height_m,
                               frame_history[hypothesis.before].ball.height_m) > 0;
  const double goal_nll = p.touch_nll + hypothesis.goal_nll;
  if (!goes_on(hypothesis, motion, p.surely)) return std::min(p.nobody_nll, goal_nll);
  if (hypothesis.jumps) return std::min(p.jump_nll, goal_nll);
  return std::min(in_air ? p.landing_nll : p.nobody_nll, goal_nll);
}

const HullIntersection* intersection_with(const HullIntersections& intersections, RobotId robot) {
  const auto found = std::find_if(
      intersections.begin(), intersections.end(),
      [robot](const HullIntersection& intersection) { return intersection.robot == robot; });
  return found == intersections.end() ? nullptr : &*found;
}

// What the ways before and after cost together, and the touch. It was this robot's alone, or the
// second between two frames: then the way after may come from the first one's place.
double nll_of(const TouchSource& source, const HullIntersection* after, double goal_nll,
              const TouchHypothesisParameters& p) {
  double nll =
      std::min(source.bounce_nll, source.kick_nll) + p.second_touch_nll + p.touch_nll + goal_nll;
  if (after != nullptr) {
    nll = std::min({nll, source.bounce_nll + after->bounce_nll,
                    source.kick_nll + after->kick_nll + p.kick_nll});
  }
  const bool is_at_hull = source.seen_gap_m <= p.intersection.slack_m;
  return std::min(nll, is_at_hull ? p.at_hull_nll : p.off_hull_nll);
}

LastTouch touch_of(const TouchSource& source, const HullIntersection* after,
                   double speed_change_mps) {
  LastTouch touch;
  touch.side = source.robot.side;
  touch.robot = source.robot;
  touch.time_s = after != nullptr ? after->time_s : source.time_s;
  touch.gap_m = after != nullptr ? after->gap_m : source.gap_m;
  touch.speed_change_mps = speed_change_mps;
  return touch;
}

void offer_sources(TouchHypothesis& hypothesis, const BallMotionFilter& motion,
                   const HypothesisContext& basis) {
  const TouchHypothesisParameters& p = basis.parameters;
  const HullIntersections intersections =
      walk(motion, basis.frame_history, hypothesis.start, hypothesis.before, p.intersection)
          .intersections;
  const double change_mps = (motion.velocity_mps() - hypothesis.before_mps).norm();
  for (const TouchSource& source : hypothesis.sources) {
    const HullIntersection* after = intersection_with(intersections, source.robot);
    const double nll = hypothesis.nll_until_touch + nll_of(source, after, hypothesis.goal_nll, p);
    hypothesis.minima.offer(toucher_of(source.robot.side), nll,
                            touch_of(source, after, change_mps));
  }
}

}  // namespace

bool may_be_touched(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
                    const Vec2& onwards_m) {
  const StoredFrame& seen = basis.frame_history[now];
  const StoredFrame& before = basis.frame_history[former];
  const Vec2& before_m = before.ball.position_m;
  if (seen.ball.position_m.cwiseAbs().x() > basis.field.half_length_m() - kNearGoal_m) return true;
  const double reach_m = kRobotRadius_m + kBallRadius_m + basis.parameters.near_m +
                         kFastestRobot_mps * (seen.time_s - before.time_s);
  const auto is_near = [&](const RobotObservation& robot) {
    if (!is_near_ball(seen, robot)) return false;
    return distance_to_segment(robot.position_m, before_m, onwards_m) <= reach_m ||
           distance_to_segment(robot.position_m, before_m, seen.ball.position_m) <= reach_m;
  };
  return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
    return std::any_of(seen.robots[side].begin(), seen.robots[side].end(), is_near);
  });
}

double goal_nll_of(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
                   const Vec2& onwards_m) {
  const Vec2& now_m = basis.frame_history[now].ball.position_m;
  const Vec2& before_m = basis.frame_history[former].ball.position_m;
  if (now_m.cwiseAbs().x() <= basis.field.half_length_m() - kNearGoal_m) return kNever;
  const double gap_m = std::min(gap_to_goals_m(basis.field, {before_m, now_m}),
                                gap_to_goals_m(basis.field, {before_m, onwards_m}));
  if (gap_m >= basis.parameters.near_m) return kNever;
  return square(gap_m / basis.parameters.post_off_m);
}

void find_touch_sources(TouchHypothesis& hypothesis, const HypothesisContext& basis) {
  const TouchHypothesisParameters& p = basis.parameters;
  const HullIntersections intersections = walk(hypothesis.motion, basis.frame_history,
                                               hypothesis.before, hypothesis.start, p.intersection)
                                              .intersections;
  double least = kNever;
  for (const HullIntersection& m : intersections)
    least = std::min({least, m.bounce_nll, m.kick_nll});
  // The first of two touches may have been another's.
  const double most = std::min(least + p.second_touch_nll, p.unlikely_nll);
  for (const HullIntersection& m : intersections) {
    const double gap_m = seen_gap_m(basis.frame_history[hypothesis.start], m.robot);
    if (std::min(m.least_gap_m, gap_m) > p.near_m) continue;
    hypothesis.sources.push_back({m.robot, gap_m, std::min(m.bounce_nll, most),
                                  std::min(m.kick_nll, most), m.time_s, m.gap_m});
  }
}

void weigh_sources(TouchHypothesis& hypothesis, std::int64_t now, const HypothesisContext& basis) {
  if (hypothesis.detections > kTellingDetections || hypothesis.start == hypothesis.before) return;
  const BallMotionFilter motion = motion_from_start(hypothesis, now, basis);
  const double turn_nll = nll_without_robot(hypothesis, motion, basis);
  hypothesis.minima = hypothesis.untouched;
  for (double& nll : hypothesis.minima.nll) nll += turn_nll;
  if (!hypothesis.sources.empty()) offer_sources(hypothesis, motion, basis);
}

}  // namespace autoref::referee
