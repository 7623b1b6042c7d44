#include "league/frame_message.hpp"

#include <cstdint>
#include <limits>

#include "league/units.hpp"

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

void start(const Frame& frame, std::uint32_t camera, DetectionFrame& detection) {
  detection.Clear();
  detection.set_frame_number(static_cast<std::uint32_t>(frame.number));
  detection.set_t_capture(frame.time_s);
  detection.set_t_sent(frame.time_s);
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

}  // namespace

void fill_detections(const Frame& frame, std::span<const CameraPosition> cameras,
                     std::span<VisionPacket> packets, const OtherDetections& others) {
  for (std::size_t i = 0; i < packets.size(); ++i) {
    packets[i].set_source(kOtherSource);
    start(frame, static_cast<std::uint32_t>(i), *packets[i].mutable_detection());
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

}  // namespace autoref::league
