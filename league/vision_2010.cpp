#include "league/vision_2010.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace autoref::league {
namespace {

std::int32_t sum_of(std::int32_t a, std::int32_t b) {
  const std::int64_t sum = std::int64_t{a} + b;
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(sum, 0, std::numeric_limits<std::int32_t>::max()));
}

// One quarter circle and the straight line stand for both defence areas; coordinates refer to the
// centres of the lines.
void add_defence_area(const FieldSize2010& old, FieldSize& size) {
  const auto line_mm = static_cast<float>(old.line_width());
  const auto half_mm = static_cast<float>(old.defense_stretch()) / 2;
  const auto goal_line_x_mm = static_cast<float>(old.field_length()) / 2;
  const float radius_mm = static_cast<float>(old.defense_radius()) - line_mm / 2;
  FieldLine& front = *size.add_field_lines();
  front.set_name("LeftPenaltyStretch");
  front.mutable_p1()->set_x(radius_mm - goal_line_x_mm);
  front.mutable_p1()->set_y(-half_mm);
  front.mutable_p2()->set_x(radius_mm - goal_line_x_mm);
  front.mutable_p2()->set_y(half_mm);
  front.set_thickness(line_mm);
  FieldArc& arc = *size.add_field_arcs();
  arc.set_name("LeftFieldLeftPenaltyArc");
  arc.mutable_center()->set_x(-goal_line_x_mm);
  arc.mutable_center()->set_y(half_mm);
  arc.set_radius(radius_mm);
  arc.set_thickness(line_mm);
}

void convert(const FieldSize2010& old, FieldSize& size) {
  size.set_field_length(old.field_length());
  size.set_field_width(old.field_width());
  size.set_goal_width(old.goal_width());
  size.set_goal_depth(old.goal_depth());
  size.set_boundary_width(sum_of(old.boundary_width(), old.referee_width()));
  size.set_center_circle_radius(old.center_circle_radius());
  size.set_line_thickness(old.line_width());
  size.set_goal_center_to_penalty_mark(old.penalty_spot_from_field_line_dist());
  add_defence_area(old, size);
}

}  // namespace

void convert(VisionPacket2010& old, VisionPacket& packet) {
  packet.Clear();
  if (old.has_detection()) packet.mutable_detection()->Swap(old.mutable_detection());
  if (!old.has_geometry()) return;
  convert(old.geometry().field(), *packet.mutable_geometry()->mutable_field());
  packet.mutable_geometry()->mutable_calib()->Swap(old.mutable_geometry()->mutable_calib());
}

}  // namespace autoref::league
