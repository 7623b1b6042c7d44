#include "strategies/skills/openings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/ball_path.hpp"

namespace autoref::strategies {
namespace {

constexpr int kAimPoints = 9;
constexpr int kPushSteps = 3;  // directions to each side of straight ahead
constexpr double kWidestPush_rad = 90_deg;
constexpr double kPush_m = 1.0;
constexpr double kFarAway_m = 10.0;    // clearance if no robot is near
constexpr double kScoreMargin = 1e-9;  // far above rounding errors

// Like lane_clearance_m if that is at least `needed_m`; otherwise any value between the clearance
// and `needed_m`.
double clearance_if_m(double needed_m, const Vec2& from_m, const Vec2& to_m,
                      const TrackedRobots& robots) {
  const double needed2 = square(std::max(0.0, needed_m));
  double least2 = kFarAway_m * kFarAway_m;
  const Lane lane(from_m, to_m);
  for (const TrackedRobot& robot : robots) {
    if (lane.is_beyond(robot.position_m, least2)) continue;
    const Vec2 near_m = lane.nearest_m(robot.position_m);
    least2 = std::min(least2, (robot.position_m - near_m).squaredNorm());
    if (least2 < needed2) break;
  }
  return std::sqrt(least2);
}

// The directions of a push, relative to straight ahead: `turn_rad` and its unit vector.
struct PushDirection {
  double turn_rad;
  Vec2 heading;
};
std::array<PushDirection, 2 * kPushSteps + 1> push_directions() {
  std::array<PushDirection, 2 * kPushSteps + 1> all;
  int step = -kPushSteps;
  for (PushDirection& direction : all) {
    const double turn_rad = kWidestPush_rad * step++ / kPushSteps;
    direction = {turn_rad, heading_of(turn_rad)};
  }
  return all;
}

constexpr double kHeadingError_rad = 0.015;  // adds to the kicker's error
constexpr double kReaction_s = 0.08;         // delay before a robot reacts to a kick
constexpr double kReach_mps2 = 3.0;          // the robot's acceleration after its reaction
constexpr double kLongestReach_m = 0.5;
constexpr double kBlock_m = kRobotRadius_m + kBallRadius_m;
constexpr double kNarrowest_m = 20_mm;  // robots closer to the ball are ignored
constexpr double kSafe_m = 150_mm;      // a pass along a lane with this much spare width is safe

double reach_m(double time_s) {
  const double t = std::max(0.0, time_s - kReaction_s);
  return std::min(kLongestReach_m, kReach_mps2 * t * t / 2);
}

// An interval of the goal line, from low to high y.
struct Span {
  double low_m;
  double high_m;
};
using Spans = boost::container::static_vector<Span, 2 * kMaxRobots>;

// Whether the shadow of a robot can cover part of the goal if the robot covers a disc of `disc_m`.
// The formula is that of add_shadow, multiplied by `to_robot_m` twice and squared, to avoid
// divisions and roots. The goal's full width allows for rounding errors.
bool may_cover_goal(const Field& field, const Vec2& from_m, const Vec2& robot_m, double disc_m) {
  const double to_goal_m = field.half_length_m() - from_m.x();
  const Vec2 to_robot = robot_m - from_m;
  if (to_robot.x() < kNarrowest_m || robot_m.x() > field.half_length_m() + kBlock_m) return false;
  const double middle_m2 = std::abs(from_m.y() * to_robot.x() + to_robot.y() * to_goal_m);
  const double beside_m2 = middle_m2 - field.half_goal_m() * to_robot.x();
  return beside_m2 <= 0 ||
         square(beside_m2 * to_robot.x()) <= square(disc_m * to_goal_m) * to_robot.squaredNorm();
}

// Adds the robot's shadow on the goal line, for a ball from `from_m`. `grown_m` is how far the
// robot can move in the meantime.
void add_shadow(double goal_x, const Vec2& from_m, const Vec2& robot_m, double grown_m,
                Spans& shadows) {
  const double to_robot_m = robot_m.x() - from_m.x();
  // Similar triangles: the shadow grows with the distance, and with the secant of the angle at
  // which the rays meet the goal line.
  const double stretch = (goal_x - from_m.x()) / to_robot_m;
  const double slope = (robot_m.y() - from_m.y()) / to_robot_m;
  const double half_m = (kBlock_m + grown_m) * stretch * std::sqrt(1 + slope * slope);
  const double middle_m = from_m.y() + (robot_m.y() - from_m.y()) * stretch;
  shadows.push_back({middle_m - half_m, middle_m + half_m});
}

// Sweeps over the intervals in order of their lower ends; the gaps are the parts that no interval
// covers.
Span widest_gap(Spans& shadows, double low_m, double high_m) {
  std::sort(shadows.begin(), shadows.end(),
            [](const Span& a, const Span& b) { return a.low_m < b.low_m; });
  Span best{low_m, low_m};
  double free_from_m = low_m;
  for (const Span& shadow : shadows) {
    const double until_m = std::min(shadow.low_m, high_m);
    if (until_m - free_from_m > best.high_m - best.low_m) best = {free_from_m, until_m};
    free_from_m = std::max(free_from_m, shadow.high_m);
  }
  if (high_m - free_from_m > best.high_m - best.low_m) best = {free_from_m, high_m};
  return best;
}

// The probability that a normally distributed value is within `z` standard deviations, accurate to
// a few hundredths.
double share_within(double z) { return z / std::sqrt(z * z + 1.1); }

}  // namespace

double lane_clearance_m(const Vec2& from_m, const Vec2& to_m, const TrackedRobots& robots) {
  return clearance_if_m(0, from_m, to_m, robots);
}

Aim best_shot(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents) {
  const double reach_m = field.half_goal_m() - 2.5 * kBallRadius_m;
  Aim best;
  double best_score = -1e9;
  for (int i = 0; i < kAimPoints; ++i) {
    const double share = 2.0 * i / (kAimPoints - 1) - 1.0;
    const Vec2 target_m(field.half_length_m(), share * reach_m);
    // More space than the radii of a robot and a ball helps little, so in a wider gap the middle is
    // safer.
    const double aside_cost = 0.02 * std::abs(share);
    const double needed_m = best_score + aside_cost - kScoreMargin;
    const double clearance_m = clearance_if_m(needed_m, ball_m, target_m, opponents);
    const double score = std::min(clearance_m, 0.25) - aside_cost;
    if (score > best_score) {
      best_score = score;
      best = {target_m, clearance_m};
    }
  }
  return best;
}

Aim best_push(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents) {
  static const std::array kDirections = push_directions();
  const Vec2 ahead = direction_of(field.goal_centre_m(Side::kEast) - ball_m, Vec2(1, 0));
  Aim best;
  double best_score = -1e9;
  for (const PushDirection& push : kDirections) {
    const Vec2 target_m = ball_m + kPush_m * to_world(push.heading, ahead);
    const double turning_cost = 0.1 * std::abs(push.turn_rad);
    const double needed_m = best_score + turning_cost - kScoreMargin;
    const double clearance_m = clearance_if_m(needed_m, ball_m, target_m, opponents);
    const double score =
        std::min(clearance_m, 0.4) - turning_cost - (is_on_field(field, target_m) ? 0.0 : 0.3);
    if (score > best_score) {
      best_score = score;
      best = {target_m, clearance_m};
    }
  }
  return best;
}

// Projects the robots' shadows from the ball onto the goal line, and takes the widest gap between
// them.
Opening widest_opening(const Field& field, const Vec2& from_m, const TrackedRobots& opponents,
                       const TrackedRobots& own, const ShotTerms& terms) {
  const double goal_x = field.half_length_m();
  if (from_m.x() > goal_x - 50_mm) return {field.goal_centre_m(Side::kEast), 0, 0};
  Spans shadows;
  const KickedBall kick(terms.kick_mps);
  for (const TrackedRobot& robot : opponents) {
    if (!may_cover_goal(field, from_m, robot.position_m, kBlock_m + kLongestReach_m)) continue;
    const double time_s = kick.roll_time_s((robot.position_m - from_m).norm());
    add_shadow(goal_x, from_m, robot.position_m, reach_m(time_s), shadows);
  }
  for (const TrackedRobot& robot : own) {
    if (robot.number != terms.but_mate && may_cover_goal(field, from_m, robot.position_m, kBlock_m))
      add_shadow(goal_x, from_m, robot.position_m, 0, shadows);
  }
  const double post_m = field.half_goal_m() - kBallRadius_m;
  const Span gap = widest_gap(shadows, -post_m, post_m);
  const Vec2 target_m(goal_x, (gap.low_m + gap.high_m) / 2);
  const Vec2 direction = target_m - from_m;
  const double distance_m = direction.norm();
  // The gap is seen at an angle, but the ball's own width is not foreshortened.
  const double sine = direction.x() / distance_m;
  const double half_m =
      std::max(0.0, (gap.high_m - gap.low_m) / 2 * sine - kBallRadius_m * (1 - sine));
  const double error_rad = std::sqrt(square(terms.kick_error_rad) + square(kHeadingError_rad));
  return {target_m, half_m, share_within(half_m / (error_rad * distance_m))};
}

// Each opponent covers a disc around its position, which grows until the ball passes.
double pass_safety(const Vec2& from_m, const Vec2& to_m, double kick_mps,
                   const TrackedRobots& opponents) {
  double least_m = kSafe_m;
  const Lane lane(from_m, to_m);
  const KickedBall kick(kick_mps);
  for (const TrackedRobot& robot : opponents) {
    if (lane.is_beyond(robot.position_m, square(kLongestReach_m + kBlock_m + least_m))) continue;
    const Vec2 near_m = lane.nearest_m(robot.position_m);
    const double aside_m = (robot.position_m - near_m).norm();
    if (aside_m > kLongestReach_m + kBlock_m + kSafe_m) continue;
    const double time_s = kick.roll_time_s((near_m - from_m).norm());
    least_m = std::min(least_m, aside_m - kBlock_m - reach_m(time_s));
    if (least_m <= 0) return 0;
  }
  return std::clamp(least_m / kSafe_m, 0.0, 1.0);
}

}  // namespace autoref::strategies
