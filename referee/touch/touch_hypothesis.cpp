#include "referee/touch/touch_hypothesis.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kFastestRobot_mps = 4.0;  // faster than any robot in the league
// Distance from the goal line up to which a ball may hit the goal.
constexpr double kNearGoal_m = 0.5;
// Number of detections used to estimate the path after a touch; friction and other touches bend a
// longer path.
constexpr int kTellingDetections = 8;
// Minimum fraction of its speed that a landing ball keeps, and maximum fraction that it gains
// sideways. It keeps 0.75 at the first hop, and 0.5 if it starts to spin. The online detector uses
// the same values.
constexpr double kLandedAlong = 0.4;
constexpr double kLandedAcross = 0.1;

// Gap from the ball's surface to the robot in that frame; kNever if the robot was not near the
// ball.
double seen_gap_m(const StoredFrame& frame, RobotId id) {
  const RobotObservation* robot = find_robot(frame.robots[id.side], id.number);
  if (robot == nullptr || !is_near_ball(frame, *robot)) return kNever;
  return gap_to_robot_m(*robot, frame.ball.position_m);
}

// The motion right after the touch: the filter runs backwards over the first detections.
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

// Whether a landing without a touch explains this motion.
bool goes_on(const TouchHypothesis& hypothesis, const BallMotionFilter& motion, double surely) {
  const Vec2& before_mps = hypothesis.before_mps;
  const double along = motion.velocity_mps().dot(before_mps);
  const double across = cross(motion.velocity_mps(), before_mps);
  const double off_mps = surely * std::sqrt(motion.velocity_variance_m2ps2());
  const double speed_mps = before_mps.norm();
  return along > (kLandedAlong * speed_mps - off_mps) * speed_mps &&
         std::abs(across) <= (kLandedAcross * speed_mps + off_mps) * speed_mps;
}

// A flying ball may seem to jump, and loses up to half of its speed when it lands.
double deviance_without_robot(const TouchHypothesis& hypothesis, const BallMotionFilter& motion,
                              const HypothesisContext& basis) {
  const TouchHypothesisParameters& p = basis.parameters;
  const FrameHistory& frame_history = basis.frame_history;
  const bool in_air = std::max(frame_history[hypothesis.start].ball.height_m,
                               frame_history[hypothesis.before].ball.height_m) > 0;
  const double goal_deviance = p.touch_deviance + hypothesis.goal_deviance;
  if (!goes_on(hypothesis, motion, p.surely)) return std::min(p.nobody_deviance, goal_deviance);
  if (hypothesis.jumps) return std::min(p.jump_deviance, goal_deviance);
  return std::min(in_air ? p.landing_deviance : p.nobody_deviance, goal_deviance);
}

const HullIntersection* intersection_with(const HullIntersections& intersections, RobotId robot) {
  const auto found = std::find_if(
      intersections.begin(), intersections.end(),
      [robot](const HullIntersection& intersection) { return intersection.robot == robot; });
  return found == intersections.end() ? nullptr : &*found;
}

// Deviance of a touch by that robot, given the paths before and after. Either it was the only touch
// between the two frames, or another touch followed. In that case, the path after the touches need
// not fit this robot.
double deviance_of(const TouchSource& source, const HullIntersection* after, double goal_deviance,
                   const TouchHypothesisParameters& p) {
  double deviance = std::min(source.bounce_deviance, source.kick_deviance) +
                    p.second_touch_deviance + p.touch_deviance + goal_deviance;
  if (after != nullptr) {
    deviance = std::min({deviance, source.bounce_deviance + after->bounce_deviance,
                         source.kick_deviance + after->kick_deviance + p.kick_deviance});
  }
  const bool is_at_hull = source.seen_gap_m <= p.intersection.slack_m;
  return std::min(deviance, is_at_hull ? p.at_hull_deviance : p.off_hull_deviance);
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
    const double deviance =
        hypothesis.deviance_until_touch + deviance_of(source, after, hypothesis.goal_deviance, p);
    hypothesis.minima.offer(toucher_of(source.robot.side), deviance,
                            touch_of(source, after, change_mps));
  }
}

}  // namespace

double SideMinima::least() const {
  return std::min({deviance[kNobody], deviance[kWest], deviance[kEast]});
}

void SideMinima::offer(Toucher toucher, double offered_deviance, const LastTouch& offered_touch) {
  if (offered_deviance >= deviance[toucher]) return;
  deviance[toucher] = offered_deviance;
  touch[toucher] = offered_touch;
}

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

double goal_deviance_of(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
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
    least = std::min({least, m.bounce_deviance, m.kick_deviance});
  // If there were two touches, another robot may have made the first.
  const double most = std::min(least + p.second_touch_deviance, p.unlikely_deviance);
  for (const HullIntersection& m : intersections) {
    const double gap_m = seen_gap_m(basis.frame_history[hypothesis.start], m.robot);
    if (std::min(m.least_gap_m, gap_m) > p.near_m) continue;
    hypothesis.sources.push_back({m.robot, gap_m, std::min(m.bounce_deviance, most),
                                  std::min(m.kick_deviance, most), m.time_s, m.gap_m});
  }
}

void weigh_sources(TouchHypothesis& hypothesis, std::int64_t now, const HypothesisContext& basis) {
  if (hypothesis.detections > kTellingDetections || hypothesis.start == hypothesis.before) return;
  const BallMotionFilter motion = motion_from_start(hypothesis, now, basis);
  const double turn_deviance = deviance_without_robot(hypothesis, motion, basis);
  hypothesis.minima = hypothesis.untouched;
  for (double& deviance : hypothesis.minima.deviance) deviance += turn_deviance;
  if (!hypothesis.sources.empty()) offer_sources(hypothesis, motion, basis);
}

}  // namespace autoref::referee
