// What rules have seen that takes more than one frame, since play last started or stopped.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "referee/decision.hpp"
#include "referee/machine/grace_timer.hpp"
#include "referee/machine/robot_watch.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// Some of the robots on the field.
class RobotSet {
 public:
  bool has(RobotId robot) const { return (bits_[robot.side] >> robot.number & 1U) != 0; }
  void add(RobotId robot) { bits_[robot.side] |= 1U << robot.number; }

 private:
  PerSide<std::uint32_t> bits_;
};

// Since when each robot has done something without a pause.
class RobotTimers {
 public:
  // Takes in whether the robot does it in the frame at `now_s`, and says for how long it has: 0
  // where it does not.
  double update(RobotId robot, bool does_it, double now_s) {
    std::optional<double>& since_s =
        since_s_[robot.side].at(static_cast<std::size_t>(robot.number));
    if (!does_it) since_s.reset();
    if (does_it && !since_s) since_s = now_s;
    return since_s ? now_s - *since_s : 0;
  }

 private:
  PerSide<std::array<std::optional<double>, kMaxRobots>> since_s_;
};

// Robots that stand where they must not, and what was measured of the one that is farthest wrong.
struct PositionViolation {
  ConcernedRobots robots;
  double worst_m = 0;

  bool any() const { return !robots.empty(); }
  // Names no more robots than a decision holds; `is_worse` makes `measured_m` the worst.
  void add(RobotId robot, double measured_m, bool is_worse) {
    if (robots.empty() || is_worse) worst_m = measured_m;
    if (robots.size() < robots.capacity()) robots.push_back(robot);
  }
};

struct AttackerNearAreaWatch {
  RobotTimers near;
  RobotSet called;
};

struct RestartDistanceWatch {
  PositionViolation before;  // opponents too near in the latest frame with the ball not in play
  RobotTimers near;
  RobotSet called;
  std::optional<double> anew_s;  // the kicker's time runs from here
};

struct KickoffPositionsWatch {
  PerSide<PositionViolation> before;  // in the latest frame with the ball not in play
};

struct PenaltyPositionsWatch {
  PerSide<PositionViolation> others;  // than kicker and keeper, in that frame
  PositionViolation keeper;
  bool is_over = false;  // the outcome is known
};

// The fastest that a kick has been whose height was not known.
struct KickSpeedWatch {
  std::optional<double> kicked_s;  // when the touch ended; none: nothing to remember
  double speed_mps = 0;
  bool is_in_air = false;
};

// Where the robots of a side were at its newest touch, and at the one before.
struct OffsideWatch {
  struct Pass {
    int touch = 0;       // its number since play began, from 1; 0: none
    double ended_s = 0;  // of that touch
    Side side = Side::kWest;
    RobotSet offside;  // its robots in an offside position
  };
  Pass newest;
  Pass before;
};

// One member for each rule that watches, named like it.
struct RuleWatch {
  CrashWatch bot_crash_unique;
  PushingWatch bot_pushed_bot;
  DribblingWatch bot_dribbled_ball_too_far;
  KeeperHoldingWatch keeper_held_ball;
  GraceTimer bot_too_fast_in_stop;
  GraceTimer stop_distance;
  GraceTimer bot_interfered_placement;
  AttackerNearAreaWatch attacker_too_close_to_defense_area;
  RestartDistanceWatch defender_too_close_to_kick_point;
  KickoffPositionsWatch kickoff_positions;
  PenaltyPositionsWatch penalty_positions;
  KickSpeedWatch bot_kicked_ball_too_fast;
  OffsideWatch offside;
};

// What is still of use when play starts: robots that have been near an area since play was stopped
// go on being so.
inline RuleWatch kept_at_start(const RuleWatch& watch) {
  RuleWatch kept;
  kept.attacker_too_close_to_defense_area = watch.attacker_too_close_to_defense_area;
  return kept;
}

}  // namespace autoref::referee
