#include "league/field_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include "league/message_fields.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::league {
namespace {

constexpr double kLongest_m = 100;
// Focal length of a typical camera; no images are taken here.
constexpr float kFocalLength_px = 1000;

std::int32_t whole_mm(double metres) {
  return static_cast<std::int32_t>(std::llround(metres * 1000));
}

// The league's list of shapes; a shape's number is its index.
constexpr std::array<std::string_view, 14> kShapes = {"",
                                                      "CenterCircle",
                                                      "TopTouchLine",
                                                      "BottomTouchLine",
                                                      "LeftGoalLine",
                                                      "RightGoalLine",
                                                      "HalfwayLine",
                                                      "CenterLine",
                                                      "LeftPenaltyStretch",
                                                      "RightPenaltyStretch",
                                                      "LeftFieldLeftPenaltyStretch",
                                                      "LeftFieldRightPenaltyStretch",
                                                      "RightFieldLeftPenaltyStretch",
                                                      "RightFieldRightPenaltyStretch"};

// Sets the type of a line or arc, unless the list does not contain the shape.
template <typename Shape>
void set_name(const std::string& name, Shape& shape) {
  shape.set_name(name);
  const auto* found = std::find(kShapes.begin(), kShapes.end(), name);
  if (found != kShapes.end()) shape.set_type(static_cast<int>(found - kShapes.begin()));
}

// Adds lines and arcs; their coordinates refer to the centres of the painted lines.
class Painter {
 public:
  Painter(const Field& field, FieldSize& size)
      : width_mm_(to_mm(field.line_width_m)), size_(size) {}

  void line(const std::string& name, const Vec2& from_m, const Vec2& to_m) {
    FieldLine& line = *size_.add_field_lines();
    set_name(name, line);
    set(from_m, *line.mutable_p1());
    set(to_m, *line.mutable_p2());
    line.set_thickness(width_mm_);
  }

  void arc(const std::string& name, const Vec2& centre_m, double radius_m, double from_rad,
           double to_rad) {
    FieldArc& arc = *size_.add_field_arcs();
    set_name(name, arc);
    set(centre_m, *arc.mutable_center());
    arc.set_radius(to_mm(radius_m));
    arc.set_a1(static_cast<float>(from_rad));
    arc.set_a2(static_cast<float>(to_rad));
    arc.set_thickness(width_mm_);
  }

 private:
  static void set(const Vec2& position_m, Point& point) {
    point.set_x(to_mm(position_m.x()));
    point.set_y(to_mm(position_m.y()));
  }

  float width_mm_;
  FieldSize& size_;
};

void paint_outline(const Field& field, Painter& painter) {
  const double x = field.half_length_m() - field.line_width_m / 2;
  const double y = field.half_width_m() - field.line_width_m / 2;
  painter.line("TopTouchLine", {-x, y}, {x, y});
  painter.line("BottomTouchLine", {-x, -y}, {x, -y});
  painter.line("LeftGoalLine", {-x, -y}, {-x, y});
  painter.line("RightGoalLine", {x, -y}, {x, y});
  painter.line("HalfwayLine", {0, -y}, {0, y});
  painter.line("CenterLine", {-x, 0}, {x, 0});
  painter.arc("CenterCircle", {0, 0}, field.centre_circle_radius_m - field.line_width_m / 2, 0,
              2 * kPi);
}

// `sign` is the sign of the goal's x coordinate, and `name` is the league's name for that end of
// the field.
void paint_round_area(const Field& field, double sign, const std::string& name, Painter& painter) {
  const double goal_x = sign * field.half_length_m();
  const double depth_m = field.defence_area.depth_m - field.line_width_m / 2;
  const double half_m = field.defence_area.straight_m / 2;
  const double x = goal_x - sign * depth_m;
  painter.line(name + "PenaltyStretch", {x, -half_m}, {x, half_m});
  const double inwards_rad = sign < 0 ? 0 : kPi;
  painter.arc(name + "FieldLeftPenaltyArc", {goal_x, half_m}, depth_m,
              sign < 0 ? inwards_rad : kPi / 2, sign < 0 ? kPi / 2 : inwards_rad);
  painter.arc(name + "FieldRightPenaltyArc", {goal_x, -half_m}, depth_m,
              sign < 0 ? 1.5 * kPi : inwards_rad, sign < 0 ? 2 * kPi : 1.5 * kPi);
}

void paint_box_area(const Field& field, double sign, const std::string& name, Painter& painter) {
  const double goal_x = sign * field.half_length_m();
  const double x = goal_x - sign * (field.defence_area.depth_m - field.line_width_m / 2);
  const double half_m = field.defence_area.straight_m / 2 - field.line_width_m / 2;
  painter.line(name + "PenaltyStretch", {x, -half_m}, {x, half_m});
  painter.line(name + "FieldLeftPenaltyStretch", {goal_x, half_m}, {x, half_m});
  painter.line(name + "FieldRightPenaltyStretch", {goal_x, -half_m}, {x, -half_m});
}

void fill_camera(std::uint32_t id, const CameraPosition& position, CameraCalibration& camera) {
  camera.set_camera_id(id);
  camera.set_focal_length(kFocalLength_px);
  camera.set_principal_point_x(0);
  camera.set_principal_point_y(0);
  camera.set_distortion(0);
  // The quaternion, scalar last, is a half-turn about x: the camera looks along -z. In the league's
  // messages (tx, ty, tz) is the field's origin in camera coordinates.
  camera.set_q0(1);
  camera.set_q1(0);
  camera.set_q2(0);
  camera.set_q3(0);
  camera.set_tx(-to_mm(position.position_m.x()));
  camera.set_ty(to_mm(position.position_m.y()));
  camera.set_tz(to_mm(position.height_m));
  camera.set_derived_camera_world_tx(to_mm(position.position_m.x()));
  camera.set_derived_camera_world_ty(to_mm(position.position_m.y()));
  camera.set_derived_camera_world_tz(to_mm(position.height_m));
}

double length_m(std::string_view name, std::int32_t mm) {
  const double metres = to_m(mm);
  if (metres > 0 && metres <= kLongest_m) return metres;
  throw std::invalid_argument(fmt::format("{} is {} mm", name, mm));
}

// The names of the lines at the front of the areas and, for boxes only, at their sides.
constexpr std::string_view kFront = "LeftPenaltyStretch";
constexpr std::string_view kBoxSide = "LeftFieldLeftPenaltyStretch";
constexpr std::string_view kQuarterCircle = "LeftFieldLeftPenaltyArc";

double extent_m(float one_mm, float other_mm) { return std::abs(to_m(one_mm) - to_m(other_mm)); }

const FieldLine* line_called(std::string_view name, const FieldSize& size) {
  for (const FieldLine& line : size.field_lines()) {
    if (line.name() == name) return &line;
  }
  return nullptr;
}

bool has_box_sizes(const FieldSize& size) {
  return size.has_penalty_area_depth() && size.has_penalty_area_width();
}

// Reads dimensions that older messages give only as lines, whose coordinates refer to their
// centres.
void read_lines(const FieldSize& size, DefenceArea& area) {
  const FieldLine* front = line_called(kFront, size);
  if (front == nullptr) return;
  area.straight_m = extent_m(front->p1().y(), front->p2().y());
  const FieldLine* side = line_called(kBoxSide, size);
  if (side == nullptr) return;
  area = {DefenceArea::Shape::kBox,
          extent_m(side->p1().x(), side->p2().x()) + to_m(front->thickness()) / 2,
          area.straight_m + to_m(side->thickness())};
  if (area.depth_m > 0 && area.depth_m <= kLongest_m && area.straight_m <= kLongest_m) return;
  throw std::invalid_argument(fmt::format("{} is {} m long", kBoxSide, area.depth_m));
}

void read_arc(const FieldArc& arc, Field& field) {
  const double outer_m = to_m(arc.radius()) + to_m(arc.thickness()) / 2;
  if (!(outer_m > 0 && outer_m <= kLongest_m)) {
    throw std::invalid_argument(fmt::format("the radius of {} is {} mm", arc.name(), arc.radius()));
  }
  if (arc.name() == "CenterCircle") field.centre_circle_radius_m = outer_m;
  if (arc.name() == kQuarterCircle) field.defence_area.depth_m = outer_m;
}

}  // namespace

void fill_ball_models(const BallModel& model, Geometry& geometry) {
  StraightBallModel& straight = *geometry.mutable_models()->mutable_straight_two_phase();
  straight.set_acc_slide(-model.slide_mps2);
  straight.set_acc_roll(-model.roll_mps2);
  straight.set_k_switch(model.switch_ratio);
  ChippedBallModel& chipped = *geometry.mutable_models()->mutable_chip_fixed_loss();
  chipped.set_damping_xy_first_hop(model.first_hop_xy);
  chipped.set_damping_xy_other_hops(model.later_hops_xy);
  chipped.set_damping_z(model.hops_z);
}

void fill_geometry(const Field& field, std::span<const CameraPosition> cameras,
                   Geometry& geometry) {
  geometry.Clear();
  FieldSize& size = *geometry.mutable_field();
  size.set_field_length(whole_mm(field.length_m));
  size.set_field_width(whole_mm(field.width_m));
  size.set_goal_width(whole_mm(field.goal_width_m));
  size.set_goal_depth(whole_mm(field.goal_depth_m));
  size.set_boundary_width(whole_mm(field.run_off_m));
  if (field.goal_line_run_off_m > 0)
    size.set_boundary_width_goal_line(whole_mm(field.goal_line_run_off_m));
  if (field.goal_substitution_area_m > 0)
    size.set_goal_substitution_area_width(whole_mm(field.goal_substitution_area_m));
  size.set_center_circle_radius(whole_mm(field.centre_circle_radius_m));
  size.set_line_thickness(whole_mm(field.line_width_m));
  size.set_goal_center_to_penalty_mark(whole_mm(field.penalty_mark_m));
  size.set_goal_height(whole_mm(field.goal_opening_height_m));
  size.set_ball_radius(to_mm(kBallRadius_m));
  size.set_max_robot_radius(to_mm(kRobotRadius_m));
  Painter painter(field, size);
  paint_outline(field, painter);
  const bool is_box = field.defence_area.shape == DefenceArea::Shape::kBox;
  if (is_box) size.set_penalty_area_depth(whole_mm(field.defence_area.depth_m));
  if (is_box) size.set_penalty_area_width(whole_mm(field.defence_area.straight_m));
  for (const Side side : kSides) {
    const auto paint = is_box ? paint_box_area : paint_round_area;
    paint(field, goal_sign(side), side == Side::kWest ? "Left" : "Right", painter);
  }
  for (std::uint32_t id = 0; id < cameras.size(); ++id)
    fill_camera(id, cameras[id], *geometry.add_calib());
}

Field field_of(const Geometry& geometry) {
  const FieldSize& size = geometry.field();
  Field field;
  field.length_m = length_m("field_length", size.field_length());
  field.width_m = length_m("field_width", size.field_width());
  field.goal_width_m = length_m("goal_width", size.goal_width());
  field.goal_depth_m = length_m("goal_depth", size.goal_depth());
  const auto length_or_0_m = [](const char* name, std::int32_t size_mm) {
    return size_mm == 0 ? 0 : length_m(name, size_mm);
  };
  field.run_off_m = length_or_0_m("boundary_width", size.boundary_width());
  field.goal_line_run_off_m =
      length_or_0_m("boundary_width_goal_line", size.boundary_width_goal_line());
  field.goal_substitution_area_m =
      length_or_0_m("goal_substitution_area_width", size.goal_substitution_area_width());
  read_lines(size, field.defence_area);
  for (const FieldArc& arc : size.field_arcs()) read_arc(arc, field);
  if (size.has_line_thickness())
    field.line_width_m = length_m("line_thickness", size.line_thickness());
  if (size.has_center_circle_radius())
    field.centre_circle_radius_m = length_m("center_circle_radius", size.center_circle_radius());
  if (size.has_goal_center_to_penalty_mark()) {
    field.penalty_mark_m =
        length_m("goal_center_to_penalty_mark", size.goal_center_to_penalty_mark());
  }
  if (size.has_goal_height())
    field.goal_opening_height_m = length_m("goal_height", size.goal_height());
  if (has_box_sizes(size)) {
    field.defence_area = {DefenceArea::Shape::kBox,
                          length_m("penalty_area_depth", size.penalty_area_depth()),
                          length_m("penalty_area_width", size.penalty_area_width())};
  }
  return field;
}

FieldGaps gaps_in(const Geometry& geometry) {
  const FieldSize& size = geometry.field();
  const bool has_arc =
      std::any_of(size.field_arcs().begin(), size.field_arcs().end(),
                  [](const FieldArc& arc) { return arc.name() == kQuarterCircle; });
  const bool has_front = line_called(kFront, size) != nullptr;
  const bool has_lines = has_front && (has_arc || line_called(kBoxSide, size) != nullptr);
  return {!size.has_goal_center_to_penalty_mark(), !has_box_sizes(size) && !has_lines};
}

std::optional<CameraPosition> calibrated_camera(const Geometry& geometry, std::uint32_t id) {
  for (const CameraCalibration& camera : geometry.calib()) {
    if (camera.camera_id() != id || !camera.has_derived_camera_world_tz()) continue;
    CameraPosition position{
        {to_m(camera.derived_camera_world_tx()), to_m(camera.derived_camera_world_ty())},
        to_m(camera.derived_camera_world_tz())};
    const bool is_near = position.position_m.norm() <= kLongest_m && position.height_m > 0 &&
                         position.height_m <= kLongest_m;
    if (is_near) return position;
  }
  return std::nullopt;
}

CameraPosition camera_of(const Geometry& geometry, std::uint32_t id, const Vec2& below_m) {
  // Without a valid calibration, the camera is assumed to be directly above `below_m`, so that a
  // flying ball has no parallax.
  return calibrated_camera(geometry, id).value_or(CameraPosition{below_m});
}

}  // namespace autoref::league
