#include "league/team/league_vision.hpp"

#include <algorithm>

#include "league/camera_clocks.hpp"
#include "league/field_message.hpp"
#include "league/frame_message.hpp"

namespace autoref::league {
namespace {

constexpr double kGeometryOfTeamsEvery_s = 1.0;

Frame seen_by_a_perfect_camera(const TeamView& view) {
  Frame frame;
  const auto add = [&frame](const TrackedRobots& robots, Side side) {
    for (const TrackedRobot& robot : robots)
      frame.robots[side].push_back({robot.number, robot.position_m, robot.heading});
  };
  add(view.own, Side::kWest);
  add(view.opponents, Side::kEast);
  frame.ball.emplace();
  frame.ball->position_m = view.ball.position_m;
  frame.ball->height_m = view.ball.is_height_known ? view.ball.height_m : 0;
  return frame;
}

}  // namespace

Frame field_frame_of(const TeamFrame& frame, Side side) {
  Frame seen = frame.detections ? *frame.detections : seen_by_a_perfect_camera(frame.view);
  seen.number = frame.view.frame;
  seen.time_s = frame.view.time_s;
  return side == Side::kWest ? seen : mirrored(seen);
}

LeagueVision::LeagueVision(const Field& field) : field_(field) { write_geometry(); }

void LeagueVision::write_geometry() {
  VisionPacket packet;
  fill_geometry(field_, cameras_, *packet.mutable_geometry());
  packet.set_source(kOtherSource);
  packet.SerializeToString(&geometry_);
}

void LeagueVision::note_camera(const Frame& frame) {
  if (!frame.ball || frame.ball->height_m) return;
  const CameraPosition& camera = frame.ball->seen_from;
  const auto is_camera = [&camera](const CameraPosition& other) {
    return other.position_m == camera.position_m && other.height_m == camera.height_m;
  };
  const bool is_known = std::any_of(cameras_.begin(), cameras_.end(), is_camera);
  if (has_seen_a_camera_ && (is_known || cameras_.size() == CameraClocks::kMaxCameras)) return;
  if (!has_seen_a_camera_) cameras_.clear();
  has_seen_a_camera_ = true;
  cameras_.push_back(camera);
  write_geometry();
  geometry_due_s_ = frame.time_s;
}

const std::vector<std::string>& LeagueVision::packets_of(const Frame& frame) {
  note_camera(frame);
  const bool is_due = frame.time_s >= geometry_due_s_;
  messages_.resize(cameras_.size());
  fill_detections(frame, cameras_, messages_);
  packets_.resize(cameras_.size() + (is_due ? 1 : 0));
  if (is_due) packets_.front() = geometry_;
  for (std::size_t i = 0; i < messages_.size(); ++i)
    messages_[i].SerializeToString(&packets_[i + (is_due ? 1 : 0)]);
  if (is_due) geometry_due_s_ = frame.time_s + kGeometryOfTeamsEvery_s;
  return packets_;
}

}  // namespace autoref::league
