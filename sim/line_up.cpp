#include "sim/line_up.hpp"

#include <algorithm>

namespace autoref::sim {
namespace {

constexpr int kRow = 8;  // robots per row; a full team makes two

}  // namespace

BodyState pose_in_line_up(const Field& field, const LineUpParameters& line_up, RobotId id) {
  const double room_m =
      field.half_length_m() - line_up.from_halfway_line_m - line_up.from_goal_line_m;
  const double gap_m = std::min(line_up.gap_m, room_m / (kRow - 1));
  const double x = -line_up.from_halfway_line_m - gap_m * (id.number % kRow);
  const int row = id.number / kRow;
  const double y = -field.half_width_m() + line_up.from_touch_line_m + line_up.gap_m * row;
  const double turn = -goal_sign(id.side);  // 1 for west, -1 for east
  BodyState pose;
  pose.position_m = {turn * x, turn * y};
  pose.heading = {turn, 0.0};
  return pose;
}

}  // namespace autoref::sim
