#include "referee/rules/called_touch.hpp"

#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// Touch times are corrected for a few frames after the first report.
constexpr double kCorrected_s = 100_ms;

}  // namespace

bool is_called(const CalledTouch& called, const BallTouch& touch) {
  return called.robot && touch.side == called.robot->side &&
         touch.began_s <= called.ended_s + kCorrected_s;
}

CalledTouch called_at(const BallTouch& touch, double now_s) {
  return {touch.robot, touch.ended_s, now_s};
}

}  // namespace autoref::referee
