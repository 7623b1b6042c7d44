// Takes robots off the field and puts them back according to the number of robots that the referee
// allows.
#pragma once

#include <bitset>

#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

class SubstitutionController {
 public:
  // `robots` is the number of robots in each side's team; `from_ball_m` is the distance that
  // returning robots keep from the ball.
  SubstitutionController(const Field& field, const PerSide<int>& robots, double from_ball_m)
      : field_(field), robots_(robots), from_ball_m_(from_ball_m) {}

  // Sets whether a robot is kept off: it then does not return until this is set to false.
  void keep_off(RobotId robot, bool is_kept_off) {
    kept_off_[robot.side].set(static_cast<std::size_t>(robot.number), is_kept_off);
  }

  // Call once per frame, before the world advances. While play is stopped, a side with too many
  // robots loses one per frame, starting 1 s after the allowance fell. The robot that leaves is the
  // one that the team names, otherwise the one with the highest number other than the keeper. If a
  // side has too few robots, the lowest-numbered missing robot that is not kept off returns
  // immediately.
  void act(const RefereeSignal& signal, const PerSide<TeamRequests>& requests, double time_s,
           sim::World& world);

 private:
  void note_allowance(Side side, int allowed, double time_s);
  void call_back(Side side, const RefereeSignal& signal, sim::World& world) const;

  Field field_;
  PerSide<int> robots_;
  double from_ball_m_;
  PerSide<std::bitset<kMaxRobots>> kept_off_;
  PerSide<int> allowed_{{kMaxRobots, kMaxRobots}};
  PerSide<double> fell_s_{};  // when the allowance last fell
};

// Returns a free position in the run-off for a returning robot of `side`. The position is in the
// side's own half, as near as possible to the halfway line. The touch line to the right of the
// side's goalkeeper is tried first. At that position, the robot's hull is more than `from_ball_m`
// from the ball and from the ball placement target. Returns nullopt if every position is taken.
std::optional<Vec2> return_position(const Field& field, Side side, const RefereeSignal& signal,
                                    const sim::World& world, double from_ball_m);

}  // namespace autoref::game
