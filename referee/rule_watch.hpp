// What rules have seen that takes more than one frame, since play last started or stopped.
#pragma once

#include <cstdint>

#include "referee/lingering.hpp"
#include "referee/robot_watch.hpp"
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

// One member for each rule that watches, named like it.
struct RuleWatch {
  CrashWatch crash;
  PushingWatch pushing;
  DribblingWatch dribbling;
  KeeperHoldingWatch keeper_holding;
  Lingering stop_speed;
  Lingering stop_distance;
  Lingering placement_interference;
};

}  // namespace autoref::referee
