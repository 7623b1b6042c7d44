// What the rules have recorded since play last started or stopped.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "referee/decision.hpp"
#include "referee/machine/grace_timer.hpp"
#include "referee/machine/robot_watch.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// Robots in forbidden positions, and the worst measured violation.
struct PositionViolation {
  ConcernedRobots robots;
  RobotId worst;
  double worst_m = 0;

  bool any() const { return !robots.empty(); }
  // Adds the robot, up to the number that a decision can name. If `is_worse`, it becomes the
  // worst.
  void add(RobotId robot, double measured_m, bool is_worse) {
    if (robots.empty() || is_worse) {
      worst = robot;
      worst_m = measured_m;
    }
    if (robots.size() < robots.capacity()) robots.push_back(robot);
  }
};

// Fouls during a stop and the free kick that follows it (2026).
struct AttackerNearAreaWatch {
  PerSide<std::optional<double>> grace_from_s;  // start of the stop, or the team's first foul
  PerSide<int> fouls;

  bool is_second() const { return fouls[Side::kWest] > 1 || fouls[Side::kEast] > 1; }
};

struct RestartDistanceWatch {
  PositionViolation before;  // opponents too near in the last frame before the ball was in play
  std::optional<double> called_s;  // time of the last call; restarts the kicker's time (2026)
};

// The touch for which a non-stopping foul was called (2026).
struct CalledTouch {
  std::optional<RobotId> robot;  // nullopt: none called
  double ended_s = 0;            // last known end of the touch
  double called_s = 0;
};

// Robots that are too fast during a stop.
struct StopSpeedWatch {
  GraceTimer robots;
  PerSide<std::optional<double>> called_s;
};

struct KickoffPositionsWatch {
  PerSide<PositionViolation> before;  // in the last frame before the ball was in play
};

struct PenaltyPositionsWatch {
  PerSide<PositionViolation> others;  // robots other than kicker and keeper, in that frame
  PositionViolation keeper;
  bool is_over = false;  // the outcome is known
};

// Top speed of a kick while the ball's height was unknown.
struct KickSpeedWatch {
  std::optional<double> kicked_s;  // when the touch ended; nullopt: no kick
  double speed_mps = 0;
  bool is_in_air = false;
};

// Which robots of a side were offside at its newest touch, and at the one before.
struct OffsideWatch {
  struct Pass {
    int touch = 0;       // number since play began, from 1; 0: none
    double ended_s = 0;  // end of that touch
    Side side = Side::kWest;
    RobotSet offside;  // the side's robots in an offside position
  };
  Pass newest;
  Pass before;
};

// One member for each rule that keeps data between frames, named after the rule.
struct RuleWatch {
  CrashWatch bot_crash_unique;
  PushingWatch bot_pushed_bot;
  DribblingWatch bot_dribbled_ball_too_far;
  KeeperHoldingWatch keeper_held_ball;
  StopSpeedWatch bot_too_fast_in_stop;
  GraceTimer stop_distance;
  GraceTimer bot_interfered_placement;
  bool interference_is_called = false;  // for the current placement
  bool boundary_is_crossed = false;     // called since the ball was last inside it
  AttackerNearAreaWatch attacker_too_close_to_defense_area;
  RestartDistanceWatch defender_too_close_to_kick_point;
  KickoffPositionsWatch kickoff_positions;
  PenaltyPositionsWatch penalty_positions;
  KickSpeedWatch bot_kicked_ball_too_fast;
  CalledTouch fast_kick;
  CalledTouch touch_in_area;
  OffsideWatch offside;
};

// The records that are kept when play starts, because a free kick belongs to the stop before it.
inline RuleWatch kept_at_start(const RuleWatch& watch) {
  RuleWatch kept;
  kept.attacker_too_close_to_defense_area = watch.attacker_too_close_to_defense_area;
  return kept;
}

}  // namespace autoref::referee
