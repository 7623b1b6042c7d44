#include "league/vision_message.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "league/message_fields.hpp"

namespace autoref::league {
namespace {

// The merger ignores detections of a robot if another one is clearly more confident.
constexpr float kSure = 1;
constexpr float kUnsure = 0.5F;

bool is_at(const CameraPosition& one, const CameraPosition& other) {
  return one.position_m == other.position_m && one.height_m == other.height_m;
}

std::size_t nearest(std::span<const CameraPosition> cameras, const Vec2& position_m) {
  std::size_t best = 0;
  double best_m2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const double distance_m2 = (cameras[i].position_m - position_m).squaredNorm();
    if (distance_m2 >= best_m2) continue;
    best_m2 = distance_m2;
    best = i;
  }
  return best;
}

std::size_t camera_of(const BallObservation& ball, std::span<const CameraPosition> cameras) {
  if (!ball.height_m) {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      if (is_at(cameras[i], ball.seen_from)) return i;
    }
  }
  return nearest(cameras, ball.position_m);
}

void fill_robot(const RobotObservation& seen, float confidence, DetectionRobot& robot) {
  robot.set_confidence(confidence);
  robot.set_robot_id(static_cast<std::uint32_t>(seen.number));
  robot.set_x(to_mm(seen.position_m.x()));
  robot.set_y(to_mm(seen.position_m.y()));
  robot.set_orientation(static_cast<float>(angle_of(seen.heading)));
  robot.set_pixel_x(0);
  robot.set_pixel_y(0);
}

void fill_ball(const BallObservation& seen, float confidence, DetectionBall& ball) {
  ball.set_confidence(confidence);
  ball.set_x(to_mm(seen.position_m.x()));
  ball.set_y(to_mm(seen.position_m.y()));
  if (seen.height_m) ball.set_z(to_mm(*seen.height_m));
  ball.set_pixel_x(0);
  ball.set_pixel_y(0);
}

void start(const Frame& frame, std::uint32_t camera, double age_s, DetectionFrame& detection) {
  detection.Clear();
  detection.set_frame_number(static_cast<std::uint32_t>(frame.number));
  detection.set_t_capture(frame.time_s - age_s);
  detection.set_t_sent(frame.time_s - age_s);
  detection.set_camera_id(camera);
}

void fill_robots(const PerSide<SeenRobots>& robots, float confidence,
                 std::span<const CameraPosition> cameras, std::span<VisionPacket> packets) {
  for (const Side side : kSides) {
    for (const RobotObservation& robot : robots[side]) {
      DetectionFrame& detection = *packets[nearest(cameras, robot.position_m)].mutable_detection();
      fill_robot(
          robot, confidence,
          side == Side::kWest ? *detection.add_robots_yellow() : *detection.add_robots_blue());
    }
  }
}

std::int32_t sum_of(std::int32_t a, std::int32_t b) {
  const std::int64_t sum = std::int64_t{a} + b;
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(sum, 0, std::numeric_limits<std::int32_t>::max()));
}

// One quarter circle and the straight line represent both defence areas; coordinates refer to the
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

void fill_detections(const Frame& frame, std::span<const CameraPosition> cameras,
                     std::span<VisionPacket> packets, const OtherDetections& others) {
  for (std::size_t i = 0; i < packets.size(); ++i) {
    packets[i].set_source(kOtherSource);
    start(frame, static_cast<std::uint32_t>(i), cameras[i].age_s, *packets[i].mutable_detection());
  }
  fill_robots(frame.robots, kSure, cameras, packets);
  fill_robots(others.robots, kUnsure, cameras, packets);
  const auto fill = [&](const BallObservation& ball, float confidence) {
    DetectionFrame& detection = *packets[camera_of(ball, cameras)].mutable_detection();
    fill_ball(ball, confidence, *detection.add_balls());
  };
  if (frame.ball) fill(*frame.ball, kSure);
  for (const BallObservation& ball : others.balls) fill(ball, kUnsure);
}

void convert(VisionPacket2010& old, VisionPacket& packet) {
  packet.Clear();
  if (old.has_detection()) packet.mutable_detection()->Swap(old.mutable_detection());
  if (!old.has_geometry()) return;
  convert(old.geometry().field(), *packet.mutable_geometry()->mutable_field());
  packet.mutable_geometry()->mutable_calib()->Swap(old.mutable_geometry()->mutable_calib());
}

}  // namespace autoref::league
