#include "sim/line_up.hpp"

#include <algorithm>

namespace autoref::sim {
namespace {

constexpr int kRow = 8;            // robots in a row; a full team makes two
constexpr double kGap_m = 300_mm;  // between robots' centres, less on short fields
constexpr double kFromHalfwayLine_m = 300_mm;
constexpr double kFromTouchLine_m = 200_mm;
constexpr double kFromGoalLine_m = 150_mm;

}  // namespace

BodyState place_in_line_up(const Field& field, RobotId id) {
  const double room_m = field.half_length_m() - kFromHalfwayLine_m - kFromGoalLine_m;
  const double gap_m = std::min(kGap_m, room_m / (kRow - 1));
  const double x = -kFromHalfwayLine_m - gap_m * (id.number % kRow);
  const int row = id.number / kRow;
  const double y = -field.half_width_m() + kFromTouchLine_m + kGap_m * row;
  const double turn = -goal_sign(id.side);  // 1 in the west, -1 in the east
  BodyState place;
  place.position_m = {turn * x, turn * y};
  place.heading = {turn, 0.0};
  return place;
}

}  // namespace autoref::sim
