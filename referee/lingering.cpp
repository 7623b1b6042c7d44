#include "referee/lingering.hpp"

namespace autoref::referee {

bool Lingering::lingers(RobotId robot, bool offends, double grace_s, double now_s) {
  Watch& watch = of(robot);
  if (!offends) {
    watch.since_s.reset();
    return false;
  }
  if (!watch.since_s) watch.since_s = now_s;
  return !watch.is_told && has_passed(*watch.since_s, grace_s, now_s);
}

}  // namespace autoref::referee
