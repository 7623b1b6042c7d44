// The input of the ground-truth rules in one frame.
#pragma once

#include <span>

#include "judge/truth/ball_history.hpp"
#include "judge/truth/play.hpp"
#include "judge/truth/true_event.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::judge::ground_truth {

struct Scene {
  const Field& field;
  const RuleBook& rules;
  double time_s = 0;
  double frame_s = 0;             // time from `before` to `now`
  const sim::WorldState& before;  // the previous frame
  const sim::WorldState& now;
  std::span<const sim::Touch> touches;
  std::span<const sim::RobotCollision> collisions;
  const Play& play;
  const BallHistory& ball;
  const RefereeSignal& signal;      // in force since the previous frame
  PerSide<int> keepers;             // their numbers
  const PerSide<double>& fouled_s;  // time of each side's latest non-stopping foul (2026)

  bool is_keeper(RobotId robot) const { return keepers[robot.side] == robot.number; }
  bool is_shootout() const { return signal.stage == Stage::kShootout; }
  // Whether a penalty kick that does not score has failed. In shoot-outs, under all rule books.
  bool may_penalty_fail() const { return is_shootout() || rules.has(RuleId::kPenaltyKickFailed); }
  // A team or, in its place, the simulator is bringing the ball to where the referee wants it.
  bool is_ball_being_placed() const {
    if (!signal.placement || !(play.placer || (play.is_stop && signal.placement->by_hand)))
      return false;
    return (signal.placement->target_m - now.ball.position_m).norm() > rules.ball_in_position_m;
  }
};

// Detects one kind of event, or several that exclude each other. Called once per frame.
class GroundTruthRule {
 public:
  virtual ~GroundTruthRule() = default;
  virtual void watch(const Scene& scene, TrueEvents& all) = 0;
};

// Calls act(id, robot) for every robot of one or both sides.
template <typename Act>
void for_each_robot(const sim::WorldState& world, Side side, const Act& act) {
  for (const sim::RobotState& robot : world.robots[side]) act(RobotId{side, robot.number}, robot);
}
template <typename Act>
void for_each_robot(const sim::WorldState& world, const Act& act) {
  for (const Side side : kSides) for_each_robot(world, side, act);
}

}  // namespace autoref::judge::ground_truth
