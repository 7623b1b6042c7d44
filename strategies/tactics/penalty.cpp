#include "strategies/tactics/penalty.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::strategies {
namespace {

constexpr double kPenaltyRunUp_m = 250_mm;  // distance from the ball to the waiting kicker's centre
constexpr double kPenaltyOnLine_m =
    30_mm;  // keeper's centre in front of its line, with its hull on the line
constexpr double kPenaltyMargin_m = 50_mm;
constexpr double kRows_m = 300_mm;  // distance between the attackers' and the defenders' row
constexpr double kGap_m = 300_mm;   // distance between neighbours in a row

}  // namespace

int penalty_kicker(const TeamView& view, const Vec2& mark_m) {
  const int count = static_cast<int>(view.own.size());
  int kicker = count - 1;
  for (int i = 1; i < count; ++i) {
    const auto distance_m = [&](int k) { return (view.own[k].position_m - mark_m).norm(); };
    if (distance_m(i) < distance_m(kicker)) kicker = i;
  }
  return kicker;
}

Waypoint penalty_run_up(const Vec2& mark_m) {
  return {mark_m - Vec2(kPenaltyRunUp_m, 0), Vec2(1, 0)};
}

Waypoint penalty_keeper(const Field& field, const Vec2& mark_m) {
  const Vec2 position_m(-field.half_length_m() + kPenaltyOnLine_m, 0);
  return {position_m, direction_of(mark_m - position_m, Vec2(1, 0))};
}

Waypoint penalty_spectator(const Field& field, const Vec2& mark_m, double clearance_m, bool ours,
                           int order) {
  const double behind_m = clearance_m + kRobotRadius_m + kPenaltyMargin_m + (ours ? 0.0 : kRows_m);
  // Positions alternate between the two sides of the middle.
  const double aside = order % 2 == 0 ? 1.0 : -1.0;
  const int positions_aside = (order + 1) / 2;
  const double y = aside * kGap_m * (positions_aside + 0.5);
  const Vec2 position_m(mark_m.x() + (ours ? -behind_m : behind_m),
                        std::clamp(y, -field.half_width_m(), field.half_width_m()));
  return {position_m, direction_of(mark_m - position_m, Vec2(1, 0))};
}

}  // namespace autoref::strategies
