#include "logs/fit/recorded_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "league/camera_clocks.hpp"
#include "league/field_message.hpp"
#include "league/log_contents.hpp"
#include "league/referee_message.hpp"
#include "logs/fit/seen_frames.hpp"

namespace autoref::logs {
namespace {

constexpr double kMilli = 1e-3;
constexpr double kFrameBreak_s = 0.1;  // a longer silence begins a frame
constexpr double kShortest_s = 1;
constexpr double kShortestInterval_s = 1e-3;
constexpr double kSlowestInterval_s = 0.2;
// Further detections in a frame are ignored.
constexpr std::size_t kMostBalls = 64;
constexpr std::size_t kMostRobots = 256;

bool lets_play_run(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

// Collects the packets of a log into frames, and the frames into parts.
class MotionReader : public league::LogVisitor {
 public:
  explicit MotionReader(const std::function<void(const RecordedMotion&)>& use) : use_(use) {}

  void on_referee(double /*time_s*/, const league::RefereePacket& packet) override {
    if (const auto signal = league::signal_of(packet))
      is_running_ = lets_play_run(signal->command.kind);
  }

  void on_vision(double time_s, const league::VisionPacket& packet) override {
    if (packet.has_geometry()) note_geometry(packet.geometry());
    if (!packet.has_detection()) return;
    ++packets_;
    const league::DetectionFrame& detection = packet.detection();
    const auto captured_s =
        clocks_.time_s(detection.camera_id(), detection.t_capture(), time_s, latest_s_);
    if (!captured_s) return;
    if (begins_frame(detection.camera_id(), *captured_s)) finish_frame();
    if (frame_.captures_s.empty()) frame_.first_s = *captured_s;
    frame_.time_s = std::max(frame_.time_s, *captured_s);
    frame_.is_running = is_running_;
    frame_.captures_s[detection.camera_id()] = *captured_s;
    add_detections(detection, *captured_s);
  }

  std::int64_t finish() {
    finish_frame();
    finish_part();
    return packets_;
  }

 private:
  void note_geometry(const league::Geometry& geometry) {
    try {
      field_ = league::field_of(geometry);
    } catch (const std::invalid_argument&) {
      return;  // `log info` reports it
    }
    cameras_.clear();
    for (const auto& camera : geometry.calib()) {
      if (const auto position = league::calibrated_camera(geometry, camera.camera_id()))
        cameras_[camera.camera_id()] = *position;
    }
  }

  bool begins_frame(std::uint32_t camera, double captured_s) const {
    return !frame_.captures_s.empty() &&
           (frame_.captures_s.contains(camera) || captured_s - frame_.first_s > kFrameBreak_s);
  }

  void add_detections(const league::DetectionFrame& detection, double captured_s) {
    const std::uint32_t camera = detection.camera_id();
    for (const auto& ball : detection.balls()) {
      const Vec2 position_m(kMilli * ball.x(), kMilli * ball.y());
      has_heights_ = has_heights_ || (std::isfinite(ball.z()) && ball.z() != 0);
      if (position_m.allFinite() && frame_.balls.size() < kMostBalls)
        frame_.balls.push_back({position_m, captured_s, camera});
    }
    for (const Side side : kSides) {
      const auto& robots =
          side == Side::kWest ? detection.robots_yellow() : detection.robots_blue();
      for (const auto& robot : robots) {
        const Vec2 position_m(kMilli * robot.x(), kMilli * robot.y());
        if (!position_m.allFinite() || !std::isfinite(robot.orientation()) ||
            robot.robot_id() >= kMaxRobots || frame_.robots.size() >= kMostRobots)
          continue;
        frame_.robots.push_back({{side, static_cast<int>(robot.robot_id())},
                                 position_m,
                                 static_cast<double>(robot.orientation()),
                                 captured_s,
                                 camera});
      }
    }
  }

  void finish_frame() {
    if (frame_.captures_s.empty()) return;
    latest_s_ = frame_.time_s;
    if (!frames_.empty() && (frames_.size() >= RecordedMotion::kMostFrames ||
                             frame_.time_s - frames_.front().time_s > RecordedMotion::kLongest_s))
      finish_part();
    if (frames_.empty() || frame_.time_s > frames_.back().time_s)
      frames_.push_back(std::move(frame_));
    frame_ = {};
  }

  void finish_part() {
    constexpr std::size_t kFewest = 4;
    if (frames_.size() >= kFewest &&
        frames_.back().time_s - frames_.front().time_s >= kShortest_s) {
      RecordedMotion motion = motion_of(frames_);
      motion.field = field_;
      motion.cameras = cameras_;
      motion.has_heights = has_heights_;
      if (motion.interval_s >= kShortestInterval_s && motion.interval_s <= kSlowestInterval_s)
        use_(motion);
    }
    frames_.clear();
  }

  const std::function<void(const RecordedMotion&)>& use_;
  league::CameraClocks clocks_;
  Field field_;
  std::map<std::uint32_t, CameraPosition> cameras_;
  bool is_running_ = true;
  bool has_heights_ = false;
  SeenFrame frame_;
  std::vector<SeenFrame> frames_;
  double latest_s_ = -std::numeric_limits<double>::infinity();
  std::int64_t packets_ = 0;
};

}  // namespace

std::size_t RecordedMotion::frame_at(double time_s) const {
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
  return after == times_s.begin() ? 0 : static_cast<std::size_t>(after - times_s.begin()) - 1;
}

RobotSight RecordedMotion::robot_at(std::size_t robot, double time_s) const {
  const std::vector<RobotSight>& sights = robots[robot].sights;
  const auto last = frames() - 1;
  std::size_t before = frame_at(time_s);
  // A capture may be earlier than the time of its frame.
  if (before < last && sights[before + 1].time_s < time_s) ++before;
  const RobotSight& from = sights[before];
  const RobotSight& to = sights[std::min(before + 1, last)];
  const double span_s = to.time_s - from.time_s;
  const double share = span_s > 0 ? std::clamp((time_s - from.time_s) / span_s, 0.0, 1.0) : 0;
  return {from.position_m + share * (to.position_m - from.position_m),
          from.heading_rad + share * (to.heading_rad - from.heading_rad),
          from.camera,
          from.is_seen && to.is_seen,
          from.is_known && to.is_known,
          time_s};
}

std::int64_t for_each_motion(const std::string& path,
                             const std::function<void(const RecordedMotion&)>& use) {
  MotionReader reader(use);
  league::read_log(path, reader, league::FrameSource::kVision);
  return reader.finish();
}

}  // namespace autoref::logs
