// Robots that do what they may do only for a while, each told once in a stop.
#pragma once

#include <array>
#include <optional>

#include "referee/referee_input.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

class GraceTimer {
 public:
  // Takes in whether the robot offends now. Answers whether it has done so for `grace_s` and has
  // not been told.
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

// Whether `a` is told before `b`: the one farther beyond the limit; of two that are equal but for
// rounding the one nearer to the centre, so that no side comes first.
bool goes_before(const GraceViolation& a, const GraceViolation& b);

// The robot that has offended for `grace_s` and is beyond the limit most, of those not told yet; it
// is told. `excess_of(side, robot)` says how far a robot is beyond the limit, in any unit; robots
// up to it do not offend.
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
