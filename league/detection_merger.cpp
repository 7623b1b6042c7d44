#include "league/detection_merger.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "league/field_message.hpp"
#include "league/message_fields.hpp"

namespace autoref::league {
namespace {

constexpr double kLongestFrame_s = 0.1;

constexpr float kFarthest_mm = 1e5F;
constexpr float kWidest_rad = 100;
// Fractions of a camera's interval: the longest frame, and a tolerance for times that vary.
constexpr double kLongestShare = 0.9;
constexpr double kShareTolerance = 0.05;
constexpr std::size_t kMostBalls = 256;  // largest number of balls in one frame
constexpr double kForgetRobot_s = 0.5;   // a robot unseen for this long may be anywhere
constexpr float kClearlyBetter = 0.3F;   // difference of confidences

bool is_position(float x, float y) {
  return std::abs(x) <= kFarthest_mm && std::abs(y) <= kFarthest_mm;
}

bool is_robot(const DetectionRobot& seen) {
  return seen.has_robot_id() && is_position(seen.x(), seen.y()) &&
         std::abs(seen.orientation()) <= kWidest_rad && !std::isnan(seen.confidence());
}

}  // namespace

const Frame* DetectionMerger::add(const VisionPacket& packet, double received_s) {
  if (packet.has_geometry()) read_geometry(packet.geometry());
  if (!packet.has_detection()) return nullptr;
  const DetectionFrame& detection = packet.detection();
  const std::uint32_t camera = detection.camera_id();
  const bool is_dated = std::abs(detection.t_capture()) <= CameraClocks::kLatestCapture_s;
  if (!is_dated || !clocks_.has_room_for(camera)) {
    ++unusable_;
    return nullptr;
  }
  const auto time_s = clocks_.time_s(camera, detection.t_capture(), received_s, last_time_s_);
  if (!time_s) {
    ++late_;
    return nullptr;
  }
  const bool is_dated_later = !in_frame_.empty() && time_s_ > last_time_s_;
  const Frame* done = is_dated_later && begins_frame(camera, *time_s) ? complete() : nullptr;
  if (in_frame_.contains(camera)) forget(camera);
  collect(detection, *time_s);
  return done;
}

const Frame* DetectionMerger::finish() {
  return in_frame_.empty() || time_s_ <= last_time_s_ ? nullptr : complete();
}

// A frame whose time is not later than that of the last frame is continued. In it, a camera's newer
// packet replaces its older one.
void DetectionMerger::forget(std::uint32_t camera) {
  const auto is_of_camera = [camera](const Detected& seen) { return seen.camera == camera; };
  for (const Side side : kSides) {
    for (Robot& robot : robots_[side]) std::erase_if(robot.seen, is_of_camera);
  }
  for (std::size_t i = balls_.size(); i-- > 0;) {
    if (!is_of_camera(balls_[i])) continue;
    balls_.erase(balls_.begin() + static_cast<std::ptrdiff_t>(i));
    ball_heights_m_.erase(ball_heights_m_.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void DetectionMerger::read_geometry(const Geometry& geometry) {
  try {
    const Field field = field_of(geometry);
    const bool is_other =
        field_ && geometry.field().SerializeAsString() != geometry_.field().SerializeAsString();
    field_changes_ += is_other ? 1 : 0;
    field_ = field;
    field_gaps_ = gaps_in(geometry);
    geometry_ = geometry;
  } catch (const std::invalid_argument&) {
    ++unusable_;
  }
}

bool DetectionMerger::begins_frame(std::uint32_t camera, double time_s) const {
  const double share = 1.0 - 1.0 / static_cast<double>(clocks_.cameras()) + kShareTolerance;
  return in_frame_.contains(camera) || time_s - time_s_ > kLongestFrame_s ||
         (interval_s_ > 0 && time_s - begun_s_ > std::min(share, kLongestShare) * interval_s_);
}

void DetectionMerger::collect(const DetectionFrame& detection, double time_s) {
  const bool begins = in_frame_.empty() || time_s_ <= last_time_s_;
  if (begins) {
    begun_s_ = time_s;
    interval_s_ = clocks_.interval_s(detection.camera_id());
  }
  time_s_ = in_frame_.empty() ? time_s : std::max(time_s_, time_s);
  in_frame_.insert(detection.camera_id());
  for (const Side side : kSides) collect_robots(detection, side);
  for (const DetectionBall& ball : detection.balls()) collect_ball(ball, detection.camera_id());
}

void DetectionMerger::collect_robots(const DetectionFrame& detection, Side side) {
  for (const DetectionRobot& seen :
       side == Side::kWest ? detection.robots_yellow() : detection.robots_blue()) {
    if (!is_robot(seen)) continue;
    if (seen.robot_id() >= kMaxRobots) {
      ++unnumbered_;
      continue;
    }
    robots_[side][seen.robot_id()].seen.push_back(
        {detection.camera_id(), seen.confidence(), Vec2(to_m(seen.x()), to_m(seen.y())),
         heading_of(static_cast<double>(seen.orientation()))});
  }
}

void DetectionMerger::collect_ball(const DetectionBall& seen, std::uint32_t camera) {
  if (!is_position(seen.x(), seen.y()) || !is_position(seen.z(), seen.z())) return;
  if (std::isnan(seen.confidence()) || balls_.size() >= kMostBalls) return;
  balls_.push_back({camera, seen.confidence(), Vec2(to_m(seen.x()), to_m(seen.y())), {1, 0}});
  ball_heights_m_.push_back(seen.has_z() ? std::optional(to_m(seen.z())) : std::nullopt);
}

std::optional<RobotObservation> DetectionMerger::robot_seen(int number, Robot& robot) {
  if (robot.seen.empty()) return std::nullopt;
  if (robot.body.is_known() && time_s_ - robot.body.seen_s() > kForgetRobot_s) robot.body.forget();
  const Detected* chosen = &*std::max_element(
      robot.seen.begin(), robot.seen.end(),
      [](const Detected& a, const Detected& b) { return a.confidence < b.confidence; });
  if (robot.body.is_known()) {
    const float least = chosen->confidence - kClearlyBetter;
    std::erase_if(robot.seen, [least](const Detected& seen) { return seen.confidence < least; });
    chosen = nearest_to(robot.body.expected_m(time_s_), robot.seen);
  }
  const Detected used = robot.body.add(time_s_, robot.seen, *chosen);
  robot.seen.clear();
  return RobotObservation{number, used.position_m, used.heading};
}

std::optional<BallObservation> DetectionMerger::ball_seen() {
  const Detected* chosen = ball_choice_.choose(time_s_, balls_);
  std::optional<BallObservation> ball;
  if (chosen != nullptr) {
    ball.emplace();
    ball->position_m = chosen->position_m;
    const Detected* seen = nearest_to(chosen->position_m, balls_);
    ball->height_m = ball_heights_m_[static_cast<std::size_t>(seen - balls_.data())];
    if (!ball->height_m) ball->seen_from = camera_of(geometry_, chosen->camera, ball->position_m);
  }
  balls_.clear();
  ball_heights_m_.clear();
  return ball;
}

const Frame* DetectionMerger::complete() {
  frame_.number = frames_++;
  frame_.time_s = time_s_;
  for (const Side side : kSides) {
    frame_.robots[side].clear();
    for (int number = 0; number < kMaxRobots; ++number) {
      const auto robot = robot_seen(number, robots_[side][static_cast<std::size_t>(number)]);
      if (robot) frame_.robots[side].push_back(*robot);
    }
  }
  frame_.ball = ball_seen();
  in_frame_.clear();
  last_time_s_ = time_s_;
  return &frame_;
}

}  // namespace autoref::league
