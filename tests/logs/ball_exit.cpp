#include "tests/logs/ball_exit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autoref::logs {
namespace {

using referee::Event;

constexpr double kShortest_s = 0.4;  // from the touch to the call
constexpr double kLongest_s = 0.9;
constexpr double kAfterTouch_s = 0.05;  // the estimated time of a touch may be as wrong
constexpr double kAfterCall_s = 0.15;
constexpr double kStraight_m = 0.015;
constexpr double kMissed_s = 0.025;  // longer than a frame, shorter than two

struct SeenBall {
  double time_s;
  Vec2 position_m;
};

bool is_exit(Event event) {
  return event == Event::kThrowIn || event == Event::kCornerKick || event == Event::kGoalKick ||
         event == Event::kGoal;
}

std::vector<SeenBall> seen_balls_in(const RefereedLog& log, double from_s, double to_s) {
  std::vector<SeenBall> seen;
  for (const Frame& frame : log.frames) {
    if (frame.ball && frame.time_s >= from_s && frame.time_s <= to_s)
      seen.push_back({frame.time_s, frame.ball->position_m});
  }
  return seen;
}

bool is_off(const Field& field, const SeenBall& ball) {
  return !is_on_field(field, ball.position_m);
}

// The exit that these detections show, if their path is straight as far as the line.
std::optional<BallExit> exit_of(const Field& field, const std::vector<SeenBall>& seen) {
  const auto off = std::find_if(seen.begin(), seen.end(),
                                [&](const SeenBall& one) { return is_off(field, one); });
  if (off == seen.end() || off - seen.begin() < 5 || seen.end() - off < 5) return std::nullopt;
  const Vec2 first_m = seen.front().position_m;
  const Vec2 direction = direction_of(off->position_m - first_m, {1, 0});
  const Crossing crossing = crossing_of(field, first_m, direction);
  BallExit exit{crossing.line, crossing.steepness, {}};
  exit.detections.reserve(seen.size());
  for (const SeenBall& one : seen) {
    const Vec2 from_line_m = to_local(one.position_m - crossing.position_m, direction);
    exit.detections.push_back({one.time_s - seen.front().time_s, from_line_m.x(), from_line_m.y()});
    const bool is_straight = std::abs(from_line_m.y()) < kStraight_m;
    if (&one <= &*off && !is_straight) return std::nullopt;
  }
  return exit;
}

}  // namespace

double BallExit::time_at_s(double at_m) const {
  const auto next = std::find_if(detections.begin() + 1, detections.end(),
                                 [at_m](const Detection& one) { return one.along_m > at_m; });
  if (next == detections.end()) return duration_s();
  const Detection& before = *(next - 1);
  const double share = (at_m - before.along_m) / (next->along_m - before.along_m);
  return before.time_s + share * (next->time_s - before.time_s);
}

std::optional<BallExit::Detection> BallExit::at(double time_s) const {
  const auto next = std::find_if(detections.begin() + 1, detections.end(),
                                 [time_s](const Detection& one) { return one.time_s >= time_s; });
  if (next == detections.end()) return std::nullopt;
  const Detection& before = *(next - 1);
  const double gap_s = next->time_s - before.time_s;
  if (gap_s > kMissed_s) return std::nullopt;
  const double share = (time_s - before.time_s) / gap_s;
  return Detection{time_s, std::lerp(before.along_m, next->along_m, share),
                   std::lerp(before.across_m, next->across_m, share)};
}

std::vector<BallExit> exits_in(const RefereedLog& log) {
  std::vector<BallExit> exits;
  for (const referee::Decision& decision : log.decisions) {
    const referee::LastTouch& touch = decision.last_touch;
    const double took_s = decision.time_s - touch.time_s;
    if (!is_exit(decision.finding.event) || !touch.robot) continue;
    if (took_s < kShortest_s || took_s > kLongest_s) continue;
    const std::optional<BallExit> exit =
        exit_of(log.field,
                seen_balls_in(log, touch.time_s + kAfterTouch_s, decision.time_s + kAfterCall_s));
    if (exit) exits.push_back(*exit);
  }
  return exits;
}

Crossing crossing_of(const Field& field, const Vec2& from_m, const Vec2& direction) {
  const auto distance = [](double half_m, double at_m, double share) {
    if (std::abs(share) < 1e-9) return std::numeric_limits<double>::infinity();
    return (std::copysign(half_m, share) - at_m) / share;
  };
  const double x_m = distance(field.half_length_m(), from_m.x(), direction.x());
  const double y_m = distance(field.half_width_m(), from_m.y(), direction.y());
  const Vec2 position_m = from_m + std::min(x_m, y_m) * direction;
  if (y_m < x_m) return {ExitLine::kTouchLine, y_m, std::abs(direction.y()), position_m};
  const bool is_goal = std::abs(position_m.y()) < field.half_goal_m();
  return {is_goal ? ExitLine::kGoal : ExitLine::kGoalLine, x_m, std::abs(direction.x()),
          position_m};
}

}  // namespace autoref::logs
