#include "strategies/tactics/turn_time.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/exponential.hpp"

namespace autoref::strategies {
namespace {

constexpr double kStartsTurning_s = 0.1;
constexpr double kLittleTurn_rad = 0.1;  // needs less time to start

}  // namespace

double chance_to_turn(const Style& style, const Hold& hold, const Vec2& aim) {
  const double turn_rad = std::max(0.0, std::abs(angle_between(hold.heading, aim)) - hold.free_rad);
  const double start_s = kStartsTurning_s * std::min(1.0, turn_rad / kLittleTurn_rad);
  const double turn_s = turn_rad / style.ball_turn_radps + start_s;
  return 1 / (1 + exponential((turn_s - hold.spare_s) / style.late_spread_s));
}

}  // namespace autoref::strategies
