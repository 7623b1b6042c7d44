#include "strategies/skills/restart_taker.hpp"

#include <algorithm>

#include "soccer/units.hpp"

namespace autoref::strategies {
namespace {

constexpr double kTouched_m = 130_mm;  // a robot this close to the ball has it

}  // namespace

void RestartTaker::update(const TeamView& now, int taker) {
  if (now.play != Play::kRunning) {
    number_ = taker;
    return;
  }
  const auto has_touched = [&](const TrackedRobot& robot) {
    return (robot.position_m - now.ball.position_m).norm() < kTouched_m;
  };
  const bool mate = std::any_of(now.own.begin(), now.own.end(), [&](const TrackedRobot& robot) {
    return robot.number != number_ && has_touched(robot);
  });
  if (mate || std::any_of(now.opponents.begin(), now.opponents.end(), has_touched)) number_ = -1;
}

}  // namespace autoref::strategies
