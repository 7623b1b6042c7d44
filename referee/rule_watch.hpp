// What rules have seen that takes more than one frame, since play last started or stopped.
#pragma once

#include <cstdint>
#include <optional>

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
  KickSpeedWatch kick_speed;
  OffsideWatch offside;
};

}  // namespace autoref::referee
