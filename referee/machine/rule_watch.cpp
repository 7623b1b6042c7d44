#include "referee/machine/rule_watch.hpp"

#include <cmath>

namespace autoref::referee {
namespace {

constexpr double kSame = 1e-6;  // excesses that differ by less are equal

}  // namespace

bool GraceTimer::is_due(RobotId robot, bool offends, double grace_s, double now_s) {
  Watch& watch = of(robot);
  if (!offends) {
    watch.since_s.reset();
    return false;
  }
  if (!watch.since_s) watch.since_s = now_s;
  return !watch.is_reported && has_passed(*watch.since_s, grace_s, now_s);
}

bool goes_before(const GraceViolation& a, const GraceViolation& b) {
  if (std::abs(a.excess - b.excess) > kSame) return a.excess > b.excess;
  return a.position_m.squaredNorm() < b.position_m.squaredNorm();
}

}  // namespace autoref::referee
