// Timers for offences that are allowed for a grace period. Each robot is reported once per stop.
#pragma once

#include <array>
#include <optional>

#include "referee/referee_input.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

class GraceTimer {
 public:
  // Records whether the robot offends now. Returns whether it has offended for `grace_s` and has
  // not been reported.
  bool is_due(RobotId robot, bool offends, double grace_s, double now_s);
  void mark_reported(RobotId robot) { of(robot).is_reported = true; }

 private:
  struct Watch {
    std::optional<double> since_s;
    bool is_reported = false;
  };
  Watch& of(RobotId robot) { return all_[robot.side][static_cast<std::size_t>(robot.number)]; }

  PerSide<std::array<Watch, kMaxRobots>> all_;
};

struct GraceViolation {
  RobotId id;
  Vec2 position_m{0, 0};
  double excess = 0;
};

// Whether `a` is reported before `b`: the larger excess first; if they are equal up to rounding,
// the robot nearer to the centre, so that neither side is favoured.
bool goes_before(const GraceViolation& a, const GraceViolation& b);

// Returns the robot with the largest excess among those that have offended for `grace_s` and have
// not been reported, and marks it reported. `excess_of(side, robot)` is how far a robot exceeds the
// limit, in any unit; robots with at most 0 do not offend.
template <typename ExcessOf>
std::optional<GraceViolation> take_worst(GraceTimer& grace_timer, const RefereeInput& input,
                                         double grace_s, const ExcessOf& excess_of) {
  std::optional<GraceViolation> worst;
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : input.tracks.robots[side]) {
      const RobotId id{side, robot.number};
      const double excess = excess_of(side, robot);
      if (!grace_timer.is_due(id, excess > 0, grace_s, input.time_s())) continue;
      const GraceViolation found{id, robot.position_m, excess};
      if (!worst || goes_before(found, *worst)) worst = found;
    }
  }
  if (worst) grace_timer.mark_reported(worst->id);
  return worst;
}

}  // namespace autoref::referee
