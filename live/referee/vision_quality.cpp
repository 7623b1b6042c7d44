#include "live/referee/vision_quality.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "league/camera_clocks.hpp"
#include "league/message_fields.hpp"

namespace autoref::live {
namespace {

constexpr std::size_t kMostKept = 20'000;  // maximum length of each list
constexpr double kSameFrame_s = 0.008;     // longest time between two cameras' detections
constexpr double kOtherRobot_m = 0.5;      // if farther apart, one of the two numbers is misread

template <typename List, typename TimeOf>
void forget(List& list, double now_s, const TimeOf& time_of) {
  while (!list.empty() &&
         (now_s - time_of(list.front()) > VisionQuality::kWindow_s || list.size() > kMostKept))
    list.pop_front();
}

double span_s(const std::deque<double>& times) {
  return times.empty() ? 0 : times.back() - times.front();
}

}  // namespace

void VisionQuality::add(double time_s, const league::VisionPacket& packet) {
  if (!packet.has_detection()) return;
  const league::DetectionFrame& detection = packet.detection();
  const std::uint32_t camera = detection.camera_id();
  if (!packets_.contains(camera) && packets_.size() == league::CameraClocks::kMaxCameras) return;
  packets_[camera].push_back(time_s);
  for (auto& [number, times] : packets_) forget(times, time_s, [](double one_s) { return one_s; });
  for (const Side side : kSides) compare(time_s, side, detection);
  forget(distances_, time_s, [](const Distance& one) { return one.time_s; });
}

void VisionQuality::compare(double time_s, Side side, const league::DetectionFrame& detection) {
  const auto& robots = side == Side::kWest ? detection.robots_yellow() : detection.robots_blue();
  for (const league::DetectionRobot& robot : robots) {
    if (robot.robot_id() >= kMaxRobots) continue;
    Detected& latest = latest_[side].at(robot.robot_id());
    const Vec2 position_m(league::to_m(robot.x()), league::to_m(robot.y()));
    const double distance_m = (position_m - latest.position_m).norm();
    const bool is_other_camera = latest.camera != detection.camera_id();
    if (is_other_camera && time_s - latest.time_s < kSameFrame_s && distance_m < kOtherRobot_m)
      distances_.push_back({time_s, distance_m});
    latest = {time_s, detection.camera_id(), position_m};
  }
}

void VisionQuality::add(const Frame& frame) {
  frames_.push_back({frame.time_s,
                     frame.ball.has_value(),
                     {{static_cast<int>(frame.robots[Side::kWest].size()),
                       static_cast<int>(frame.robots[Side::kEast].size())}}});
  forget(frames_, frame.time_s, [](const FrameCount& one) { return one.time_s; });
}

VisionReport VisionQuality::report() const {
  VisionReport report;
  for (const auto& [camera, times] : packets_) {
    const double length_s = span_s(times);
    report.rates_hz[camera] = length_s > 0 ? static_cast<double>(times.size() - 1) / length_s : 0;
  }
  PerSide<int> most;
  double balls = 0;
  double robots = 0;
  for (const FrameCount& frame : frames_) {
    balls += frame.has_ball ? 1 : 0;
    for (const Side side : kSides) {
      robots += frame.robots[side];
      most[side] = std::max(most[side], frame.robots[side]);
    }
  }
  const auto frames = static_cast<double>(frames_.size());
  const double expected = frames * (most[Side::kWest] + most[Side::kEast]);
  if (frames > 0) report.ball_seen = balls / frames;
  if (expected > 0) report.robots_seen = robots / expected;
  std::vector<double> distances_m;
  distances_m.reserve(distances_.size());
  for (const Distance& one : distances_) distances_m.push_back(one.distance_m);
  if (distances_m.empty()) return report;
  const auto middle = distances_m.begin() + static_cast<std::ptrdiff_t>(distances_m.size() / 2);
  std::nth_element(distances_m.begin(), middle, distances_m.end());
  report.cameras_disagree_m = *middle;
  return report;
}

std::string text_of(const VisionReport& report) {
  if (report.rates_hz.empty()) return "no vision packets";
  std::string text;
  for (const auto& [camera, rate_hz] : report.rates_hz)
    text += fmt::format("{}camera {}: {:.1f} Hz", text.empty() ? "" : ", ", camera, rate_hz);
  text += fmt::format("; missed: ball {:.1f} %, robots {:.1f} %", 100 * (1 - report.ball_seen),
                      100 * (1 - report.robots_seen));
  if (report.cameras_disagree_m)
    text += fmt::format("; cameras disagree by {:.0f} mm", 1000 * *report.cameras_disagree_m);
  return text;
}

}  // namespace autoref::live
