#include "referee/machine/rule_watch.hpp"

#include <cmath>

namespace autoref::referee {
namespace {

constexpr double kSame = 1e-6;  // excesses that differ by less than this are equal

}  // namespace

bool GraceTimer::is_due(RobotId robot, bool offends, double grace_s, double now_s) {
  Timer& timer = of(robot);
  if (!offends) {
    timer.since_s.reset();
    return false;
  }
  if (!timer.since_s) timer.since_s = now_s;
  return !timer.is_reported && has_passed(*timer.since_s, grace_s, now_s);
}

bool goes_before(const GraceViolation& a, const GraceViolation& b) {
  if (std::abs(a.excess - b.excess) > kSame) return a.excess > b.excess;
  return a.position_m.squaredNorm() < b.position_m.squaredNorm();
}

}  // namespace autoref::referee
