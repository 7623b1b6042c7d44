#include "logs/fit/recorded_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include "league/camera_clocks.hpp"
#include "league/field_message.hpp"
#include "league/log_contents.hpp"
#include "league/referee_message.hpp"
#include "logs/fit/estimate.hpp"
#include "logs/fit/sights.hpp"
#include "soccer/units.hpp"

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
constexpr double kUsualShare = 0.02;  // of the frames in which a robot must be seen
constexpr double kFar_m = 9;          // distance to the nearest robot if none is known

// The ball is followed to the nearest detection that a kicked ball could have reached. After some
// detections out of reach, any detection is taken.
constexpr double kFastest_mps = 9;
constexpr double kReach_m = 50_mm;
constexpr int kMostRejected = 3;
// Several cameras see the same ball within this distance.
constexpr double kSameBall_m = 60_mm;
// A single detection that is farther from the middle of its neighbours than this, and by more than
// twice their distance, is not the ball.
constexpr double kSpike_m = 60_mm;

struct SeenBall {
  Vec2 position_m;
  double time_s;
  std::uint32_t camera;
};

struct SeenRobot {
  RobotId id;
  Vec2 position_m;
  double heading_rad;
  std::uint32_t camera;
};

struct SeenFrame {
  double first_s = 0;
  double time_s = 0;
  bool is_running = true;
  std::map<std::uint32_t, double> captures_s;  // by camera
  std::vector<SeenBall> balls;
  std::vector<SeenRobot> robots;
};

bool lets_play_run(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

// Follows the ball through frames in order.
class BallTrail {
 public:
  void add(const SeenFrame& frame, RecordedMotion& motion) {
    BallSight sight;
    sight.time_s = frame.time_s;
    sight.camera = last_ ? last_->camera : 0;
    const SeenBall* chosen = chosen_of(frame);
    if (chosen != nullptr) {
      sight = {chosen->position_m, chosen->time_s, chosen->camera, true};
      last_ = *chosen;
      rejected_ = 0;
    } else if (!frame.balls.empty()) {
      ++rejected_;
    }
    note_others(frame, chosen, motion);
    motion.ball.push_back(sight);
  }

 private:
  const SeenBall* chosen_of(const SeenFrame& frame) const {
    if (frame.balls.empty()) return nullptr;
    if (!last_) return &frame.balls.front();
    const auto distance_m = [&](const SeenBall& ball) {
      return (ball.position_m - last_->position_m).norm();
    };
    const SeenBall* nearest = &frame.balls.front();
    for (const SeenBall& ball : frame.balls) {
      if (distance_m(ball) < distance_m(*nearest)) nearest = &ball;
    }
    const double reach_m = kReach_m + kFastest_mps * (nearest->time_s - last_->time_s);
    if (distance_m(*nearest) > reach_m && rejected_ < kMostRejected) return nullptr;
    if (nearest->camera == last_->camera) return nearest;
    for (const SeenBall& ball : frame.balls) {
      if (ball.camera == last_->camera &&
          (ball.position_m - nearest->position_m).norm() < kSameBall_m)
        return &ball;
    }
    return nearest;
  }

  static void note_others(const SeenFrame& frame, const SeenBall* chosen, RecordedMotion& motion) {
    for (const SeenBall& ball : frame.balls) {
      const bool is_same =
          chosen != nullptr &&
          (&ball == chosen || (ball.camera != chosen->camera &&
                               (ball.position_m - chosen->position_m).norm() < kSameBall_m));
      if (!is_same) motion.other_balls.push_back({motion.ball.size(), ball.position_m});
    }
  }

  std::optional<SeenBall> last_;
  int rejected_ = 0;
};

std::vector<std::size_t> frames_with_ball(const RecordedMotion& motion) {
  std::vector<std::size_t> seen;
  seen.reserve(motion.frames());
  for (std::size_t i = 0; i < motion.frames(); ++i) {
    if (motion.ball[i].is_seen) seen.push_back(i);
  }
  return seen;
}

void drop_spikes(RecordedMotion& motion) {
  const std::vector<std::size_t> seen = frames_with_ball(motion);
  for (std::size_t i = 1; i + 1 < seen.size(); ++i) {
    const Vec2& before_m = motion.ball[seen[i - 1]].position_m;
    const Vec2& after_m = motion.ball[seen[i + 1]].position_m;
    const double off_m = (motion.ball[seen[i]].position_m - (before_m + after_m) / 2).norm();
    if (off_m > kSpike_m && 2 * (after_m - before_m).norm() < off_m)
      motion.spikes.push_back(seen[i]);
  }
  for (const std::size_t frame : motion.spikes) motion.ball[frame].is_seen = false;
}

void interpolate_ball(RecordedMotion& motion) {
  const std::vector<std::size_t> seen = frames_with_ball(motion);
  if (seen.empty()) return;
  std::size_t next = 0;
  for (std::size_t i = 0; i < motion.frames(); ++i) {
    if (next < seen.size() && seen[next] == i) {
      ++next;
      continue;
    }
    BallSight& ball = motion.ball[i];
    ball.time_s = motion.times_s[i];
    const BallSight& after = motion.ball[seen[std::min(next, seen.size() - 1)]];
    const BallSight& before = motion.ball[seen[next > 0 ? next - 1 : 0]];
    const double span_s = after.time_s - before.time_s;
    const double share =
        span_s > 0 ? std::clamp((ball.time_s - before.time_s) / span_s, 0.0, 1.0) : 0;
    ball.position_m = before.position_m + share * (after.position_m - before.position_m);
    ball.camera = before.camera;
  }
}

double wrapped_rad(double angle_rad) { return std::remainder(angle_rad, 2 * M_PI); }

// Of several detections of the robot in a frame, the one by the camera used last; of several by
// that camera, or of several by others, the nearest to where it was.
const SeenRobot* chosen_robot(const SeenFrame& frame, const RobotId& id, const RobotSight& last) {
  const SeenRobot* chosen = nullptr;
  const auto rank = [&](const SeenRobot& robot) {
    const double distance_m = last.is_seen ? (robot.position_m - last.position_m).norm() : 0;
    return std::pair(last.is_seen && robot.camera != last.camera, distance_m);
  };
  for (const SeenRobot& robot : frame.robots) {
    if (robot.id == id && (chosen == nullptr || rank(robot) < rank(*chosen))) chosen = &robot;
  }
  return chosen;
}

void interpolate_robot(const std::vector<double>& times_s, std::vector<RobotSight>& sights) {
  std::size_t before = sights.size();
  for (std::size_t i = 0; i < sights.size(); ++i) {
    if (!sights[i].is_seen) continue;
    sights[i].is_known = true;
    if (before < i) {
      const double span_s = times_s[i] - times_s[before];
      const bool is_short = span_s <= RecordedMotion::kLongestGap_s;
      for (std::size_t k = before + 1; k < i; ++k) {
        const double share = (times_s[k] - times_s[before]) / span_s;
        const RobotSight& from = sights[before];
        sights[k] = {from.position_m + share * (sights[i].position_m - from.position_m),
                     from.heading_rad + share * (sights[i].heading_rad - from.heading_rad),
                     from.camera, false, is_short};
      }
    }
    before = i;
  }
}

RobotMotion robot_motion(const RobotId& id, const std::vector<SeenFrame>& frames,
                         const std::vector<double>& times_s) {
  RobotMotion motion{id, std::vector<RobotSight>(frames.size())};
  RobotSight last;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const SeenRobot* seen = chosen_robot(frames[i], id, last);
    if (seen == nullptr) continue;
    const double heading_rad =
        last.is_seen ? last.heading_rad + wrapped_rad(seen->heading_rad - last.heading_rad)
                     : seen->heading_rad;
    last = {seen->position_m, heading_rad, seen->camera, true, true};
    motion.sights[i] = last;
  }
  interpolate_robot(times_s, motion.sights);
  return motion;
}

void add_robots(const std::vector<SeenFrame>& frames, RecordedMotion& motion) {
  using Id = std::pair<Side, int>;
  std::map<Id, std::size_t> seen;
  for (const SeenFrame& frame : frames) {
    std::set<Id> ids;
    for (const SeenRobot& robot : frame.robots) ids.insert({robot.id.side, robot.id.number});
    for (const Id& id : ids) ++seen[id];
  }
  for (const auto& [id, count] : seen) {
    if (static_cast<double>(count) >= kUsualShare * static_cast<double>(frames.size()))
      motion.robots.push_back(robot_motion({id.first, id.second}, frames, motion.times_s));
  }
}

// At most one pair of cameras per robot.
void note_double_sights(const SeenFrame& frame, RecordedMotion& motion) {
  std::map<std::pair<Side, int>, const SeenRobot*> first_sights;
  std::set<std::pair<Side, int>> noted;
  for (const SeenRobot& robot : frame.robots) {
    const std::pair id(robot.id.side, robot.id.number);
    const SeenRobot* other = first_sights.try_emplace(id, &robot).first->second;
    if (other->camera == robot.camera || !noted.insert(id).second) continue;
    const auto& [first, second] = std::minmax(
        *other, robot, [](const auto& a, const auto& b) { return a.camera < b.camera; });
    motion.double_sights.push_back({motion.ball.size(), robot.id, first.camera, second.camera,
                                    second.position_m - first.position_m});
  }
}

void find_nearest_robots(RecordedMotion& motion) {
  motion.nearest_m.assign(motion.frames(), kFar_m);
  motion.nearest_robot.assign(motion.frames(), 0);
  for (std::size_t robot = 0; robot < motion.robots.size(); ++robot) {
    for (std::size_t i = 0; i < motion.frames(); ++i) {
      const RobotSight& sight = motion.robots[robot].sights[i];
      if (!sight.is_known) continue;
      const double distance_m = (sight.position_m - motion.ball[i].position_m).norm();
      if (distance_m >= motion.nearest_m[i]) continue;
      motion.nearest_m[i] = distance_m;
      motion.nearest_robot[i] = robot;
    }
  }
}

double ball_noise_of(const RecordedMotion& motion) {
  const std::span<const BallSight> ball = motion.ball;
  std::vector<double> differences;
  for (std::size_t i = 0; i + kThirdDifferenceValues <= ball.size(); ++i) {
    const auto four = ball.subspan(i, kThirdDifferenceValues);
    if (!is_seen_by_one_camera(four)) continue;
    const Vec2 difference_m = third_difference_m(four);
    differences.push_back(std::abs(difference_m.x()));
    differences.push_back(std::abs(difference_m.y()));
  }
  return differences.empty() ? 0 : noise_in(std::move(differences));
}

RecordedMotion motion_of(const std::vector<SeenFrame>& frames) {
  RecordedMotion motion;
  BallTrail trail;
  motion.times_s.reserve(frames.size());
  motion.is_running.reserve(frames.size());
  motion.ball.reserve(frames.size());
  for (const SeenFrame& frame : frames) {
    motion.times_s.push_back(frame.time_s);
    motion.is_running.push_back(static_cast<char>(frame.is_running));
    for (const auto& [camera, time_s] : frame.captures_s)
      motion.captures_s[camera].push_back(time_s);
    note_double_sights(frame, motion);
    trail.add(frame, motion);
  }
  motion.interval_s = median_step(motion.times_s);
  drop_spikes(motion);
  interpolate_ball(motion);
  add_robots(frames, motion);
  find_nearest_robots(motion);
  motion.ball_noise_m = std::max(ball_noise_of(motion), RecordedMotion::kLeastNoise_m);
  return motion;
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
  const std::size_t before = frame_at(time_s);
  const std::size_t after = std::min(before + 1, frames() - 1);
  const double span_s = times_s[after] - times_s[before];
  const double share = span_s > 0 ? std::clamp((time_s - times_s[before]) / span_s, 0.0, 1.0) : 0;
  const RobotSight& from = sights[before];
  const RobotSight& to = sights[after];
  return {from.position_m + share * (to.position_m - from.position_m),
          from.heading_rad + share * (to.heading_rad - from.heading_rad), from.camera,
          from.is_seen && to.is_seen, from.is_known && to.is_known};
}

std::int64_t for_each_motion(const std::string& path,
                             const std::function<void(const RecordedMotion&)>& use) {
  MotionReader reader(use);
  league::read_log(path, reader, league::FrameSource::kVision);
  return reader.finish();
}

}  // namespace autoref::logs
