#include "strategies/rowdy/foul_behaviours.hpp"

#include <array>
#include <cmath>

#include "strategies/skills/limits.hpp"
#include "strategies/skills/play_ball.hpp"
#include "strategies/skills/prediction.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kSceneClearance_m = 2 * kRobotRadius_m + 20_mm;
constexpr double kSceneLane_m = 250_mm;  // half the width of a cleared path
constexpr double kSceneTouch_m = kFrontDistance_m + kBallRadius_m;

// The robot nearest to a point, if it is within `reach_m`; the robot with the number `except` is
// excluded.
const TrackedRobot* nearest(const TrackedRobots& robots, int except, const Vec2& point_m,
                            double reach_m) {
  const TrackedRobot* best = nullptr;
  for (const TrackedRobot& robot : robots) {
    const double distance_m = (robot.position_m - point_m).norm();
    if (robot.number == except || distance_m >= reach_m) continue;
    best = &robot;
    reach_m = distance_m;
  }
  return best;
}

Obstacles everybody_but(const RowdyView& view, int number) {
  Obstacles obstacles;
  obstacles.farthest_m = farthest_between_walls_m(view.field);
  for (const TrackedRobot& mate : view.now.own) {
    if (mate.number != number) obstacles.push_back({mate.position_m, kSceneClearance_m});
  }
  for (const TrackedRobot& opponent : view.now.opponents) {
    obstacles.push_back({opponent.position_m, kSceneClearance_m});
  }
  return obstacles;
}

}  // namespace

const TrackedRobot* find(const TrackedRobots& robots, int number) {
  for (const TrackedRobot& robot : robots) {
    if (robot.number == number) return &robot;
  }
  return nullptr;
}

const TrackedRobot* nearest_mate(const RowdyView& view, const Vec2& point_m, double reach_m) {
  return nearest(view.now.own, view.keeper, point_m, reach_m);
}

const TrackedRobot* nearest_opponent(const RowdyView& view, const Vec2& point_m, double reach_m) {
  return nearest(view.now.opponents, -1, point_m, reach_m);
}

bool has_ball(const TrackedRobot& robot, const TrackedBall& ball) {
  const Vec2 at_m = to_local(ball.position_m - robot.position_m, robot.heading);
  return at_m.x() > 0 && at_m.x() < kSceneTouch_m + 15_mm &&
         std::abs(at_m.y()) < kDribblerZoneWidth_m / 2;
}

bool is_running(const RowdyView& view) { return view.now.play == Play::kRunning; }

bool is_own_restart(const RowdyView& view) {
  return view.now.ours && is_restart(view.now.play) && view.now.play != Play::kPenalty;
}

bool is_opponents_restart(const RowdyView& view) {
  return !view.now.ours && is_restart(view.now.play) && view.now.play != Play::kPenalty;
}

bool is_free_kick(Play play) { return play == Play::kDirectFree || play == Play::kIndirectFree; }

RobotCommand go_to(const RowdyView& view, const TrackedRobot& robot, const Vec2& position_m) {
  const Vec2 heading = direction_of(view.now.ball.position_m - position_m, robot.heading);
  return drive_to(robot, {position_m, heading}, everybody_but(view, robot.number), {});
}

RobotCommand charge(const TrackedRobot& robot, const Vec2& velocity_mps) {
  return drive_with(robot, velocity_mps, direction_of(velocity_mps, robot.heading), {});
}

RobotCommand charge_at(const TrackedRobot& robot, const Vec2& point_m, double speed_mps) {
  return charge(robot, direction_of(point_m - robot.position_m, robot.heading) * speed_mps);
}

RobotCommand kick_at(const RowdyView& view, const TrackedRobot& robot, const Vec2& target_m,
                     double kick_mps) {
  const Vec2 interception_m = intercept(robot, view.now.ball).point_m;
  return play_ball(robot, view.now.ball, interception_m, {target_m, kick_mps},
                   everybody_but(view, robot.number), {});
}

void hold_back(const RowdyView& view, int number, const Vec2& point_m, double reach_m,
               TeamCommands& commands) {
  for (const TrackedRobot& mate : view.now.own) {
    if (mate.number == number || (mate.position_m - point_m).norm() > reach_m) continue;
    commands[static_cast<std::size_t>(mate.number)] = RobotCommand{};
  }
}

void clear_lane(const RowdyView& view, int number, const Vec2& from_m, const Vec2& to_m,
                TeamCommands& commands) {
  const Vec2 direction = direction_of(to_m - from_m, Vec2(1, 0));
  for (const TrackedRobot& mate : view.now.own) {
    if (mate.number == number) continue;
    const Vec2 on_lane_m = nearest_on_segment(mate.position_m, from_m, to_m);
    if ((mate.position_m - on_lane_m).norm() > kSceneLane_m) continue;
    const double side = cross(direction, mate.position_m - from_m) > 0 ? 1.0 : -1.0;
    commands[static_cast<std::size_t>(mate.number)] =
        go_to(view, mate, on_lane_m + left_of(direction) * (side * 1.5 * kSceneLane_m));
  }
}

std::span<const FoulBehaviour* const, kKindCount> all_kinds() {
  static constexpr std::array<const FoulBehaviour*, kKindCount> kAll = {
      &kAimlessKick,   &kAttackInArea, &kChipGoal,    &kCrowdRestart,  &kDelay,
      &kHardKick,      &kIndirectShot, &kKeeperHold,  &kKeeperOffLine, &kKickoffIntruder,
      &kLongDribble,   &kNearArea,     &kOwnGoalKick, &kPenaltyCrowd,  &kPlayAtOwnArea,
      &kPlayInOwnArea, &kRam,          &kRamEvenly,   &kSecondTouch,   &kShove,
      &kStopCrowd,     &kStopSprint,   &kTimeout};
  return kAll;
}

}  // namespace autoref::strategies::rowdy
