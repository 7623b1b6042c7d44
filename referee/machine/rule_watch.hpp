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

// Of one stop and the free kick after it (2026).
struct AttackerNearAreaWatch {
  PerSide<std::optional<double>> grace_from_s;  // when the stop began, or the team's first foul was
  PerSide<int> fouls;

  bool is_second() const { return fouls[Side::kWest] > 1 || fouls[Side::kEast] > 1; }
};

struct RestartDistanceWatch {
  PositionViolation before;  // opponents too near in the latest frame with the ball not in play
  std::optional<double> called_s;  // the kicker's time runs from here (2026)
};

// The touch that a foul was called for that does not stop play (2026).
struct CalledTouch {
  std::optional<RobotId> robot;  // none: nothing has been called
  double ended_s = 0;            // of the touch, as far as it is known
  double called_s = 0;
};

// Robots too fast in a stop.
struct StopSpeedWatch {
  GraceTimer robots;
  PerSide<std::optional<double>> called_s;
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
  StopSpeedWatch bot_too_fast_in_stop;
  GraceTimer stop_distance;
  GraceTimer bot_interfered_placement;
  bool interference_is_called = false;  // of the placement that is on
  AttackerNearAreaWatch attacker_too_close_to_defense_area;
  RestartDistanceWatch defender_too_close_to_kick_point;
  KickoffPositionsWatch kickoff_positions;
  PenaltyPositionsWatch penalty_positions;
  KickSpeedWatch bot_kicked_ball_too_fast;
  CalledTouch fast_kick;
  CalledTouch touch_in_area;
  OffsideWatch offside;
};

// What is still of use when play starts: a free kick belongs to the stop before it.
inline RuleWatch kept_at_start(const RuleWatch& watch) {
  RuleWatch kept;
  kept.attacker_too_close_to_defense_area = watch.attacker_too_close_to_defense_area;
  return kept;
}

}  // namespace autoref::referee
