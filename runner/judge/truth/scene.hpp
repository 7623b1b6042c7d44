// All that a truth is told from, in one frame.
#pragma once

#include <span>

#include "runner/judge/truth/ball_history.hpp"
#include "runner/judge/truth/play.hpp"
#include "runner/judge/truth/true_event.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::runner::ground_truth {

struct Scene {
  const Field& field;
  const RuleBook& rules;
  double time_s = 0;
  double frame_s = 0;             // from `before` to `now`
  const sim::WorldState& before;  // one frame earlier
  const sim::WorldState& now;
  std::span<const sim::Touch> touches;
  std::span<const sim::RobotCollision> collisions;
  const Play& play;
  const BallHistory& ball;
  const RefereeSignal& signal;  // what has been in force since the frame before
  PerSide<int> keepers;         // their numbers
  PerSide<double> fouled_s;     // each side's last non-stopping foul of 2026

  bool is_keeper(RobotId robot) const { return keepers[robot.side] == robot.number; }
  // Play is stopped, and the ball is not yet where the referee wants it.
  bool is_ball_being_placed() const {
    if (!play.is_stop || !signal.placement) return false;
    return (signal.placement->target_m - now.ball.position_m).norm() > rules.ball_in_position_m;
  }
};

// Tells one kind of event, or some that exclude each other. Asked once in every frame.
class GroundTruthRule {
 public:
  virtual ~GroundTruthRule() = default;
  virtual void watch(const Scene& scene, TrueEvents& all) = 0;
};

// Calls act(id, robot) for every robot of a side, or of both.
template <typename Act>
void for_each_robot(const sim::WorldState& world, Side side, const Act& act) {
  for (const sim::RobotState& robot : world.robots[side]) act(RobotId{side, robot.number}, robot);
}
template <typename Act>
void for_each_robot(const sim::WorldState& world, const Act& act) {
  for (const Side side : kSides) for_each_robot(world, side, act);
}

}  // namespace autoref::runner::ground_truth
