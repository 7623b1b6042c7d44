#include "league/tracker_message.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace autoref::league {
namespace {

constexpr double kSilence_s = 1;
constexpr std::size_t kMostSources = 64;
constexpr std::size_t kLongestSourceName = 64;  // bytes

constexpr int kDetectsFlyingBalls = 1;  // the capability to detect flying balls
constexpr double kTrackerLeap_s = 1;    // larger steps of a tracker's clock are jumps
constexpr double kStep_s = 1e-3;        // the shortest time between frames after a jump
constexpr double kLongestTrack_s = 1e6;
constexpr double kFarthest_m = 100;
constexpr double kFastest = 1000;  // largest credible speed, in m/s or rad/s
constexpr int kYellow = 1;
constexpr int kBlue = 2;

bool is_within(double value, double limit) { return std::abs(value) <= limit; }

template <typename Point>
std::optional<Vec2> vector_of(const Point& point, double limit) {
  const Vec2 v(static_cast<double>(point.x()), static_cast<double>(point.y()));
  return is_within(v.x(), limit) && is_within(v.y(), limit) ? std::optional(v) : std::nullopt;
}

template <typename Object>
Vec2 velocity_of(const Object& object) {
  return object.has_vel() ? vector_of(object.vel(), kFastest).value_or(Vec2{0, 0}) : Vec2{0, 0};
}

// The visibility; 1 if the tracker does not report it.
template <typename Object>
double visibility_of(const Object& object) {
  return object.has_visibility() ? static_cast<double>(object.visibility()) : 1;
}

std::optional<Side> side_of(int team) {
  if (team == kYellow) return Side::kWest;
  return team == kBlue ? std::optional(Side::kEast) : std::nullopt;
}

std::optional<TrackedRobot> robot_of(const TrackerRobot& seen) {
  const std::optional<Vec2> position_m = vector_of(seen.pos(), kFarthest_m);
  const auto heading_rad = static_cast<double>(seen.orientation());
  if (!position_m || !is_within(heading_rad, kFarthest_m)) return std::nullopt;
  const auto turn_radps = static_cast<double>(seen.vel_angular());
  return TrackedRobot{static_cast<int>(seen.robot_id().id()),
                      *position_m,
                      heading_of(heading_rad),
                      velocity_of(seen),
                      is_within(turn_radps, kFastest) ? turn_radps : 0,
                      visibility_of(seen) > 0};
}

std::optional<TrackedBall> ball_of(const TrackerBall& seen) {
  const std::optional<Vec2> position_m = vector_of(seen.pos(), kFarthest_m);
  const auto height_m = static_cast<double>(seen.pos().z());
  if (!position_m || !is_within(height_m, kFarthest_m)) return std::nullopt;
  return TrackedBall{*position_m, velocity_of(seen), std::max(0.0, height_m)};
}

template <typename Point>
void set(const Vec2& v, Point& point) {
  point.set_x(static_cast<float>(v.x()));
  point.set_y(static_cast<float>(v.y()));
}

void fill_robot(const TrackedRobot& robot, Side side, TrackerRobot& message) {
  message.mutable_robot_id()->set_id(static_cast<std::uint32_t>(robot.number));
  message.mutable_robot_id()->set_team(side == Side::kWest ? kYellow : kBlue);
  set(robot.position_m, *message.mutable_pos());
  set(robot.velocity_mps, *message.mutable_vel());
  message.set_orientation(static_cast<float>(angle_of(robot.heading)));
  message.set_vel_angular(static_cast<float>(robot.angular_velocity_radps));
  message.set_visibility(robot.is_seen ? 1 : 0);
}

void fill_ball(const TrackedBall& ball, TrackerBall& message) {
  set(ball.position_m, *message.mutable_pos());
  message.mutable_pos()->set_z(static_cast<float>(ball.height_m));
  set(ball.velocity_mps, *message.mutable_vel());
  message.mutable_vel()->set_z(0);
}

}  // namespace

bool FollowedSource::follows(std::string_view name, double received_s) {
  name = name.substr(0, kLongestSourceName);
  const bool is_first = sources_.empty();
  if (sources_.size() < kMostSources) sources_.emplace(name);
  const bool is_other = is_first || name != name_;
  if (is_other && !is_first && std::abs(received_s - heard_s_) <= kSilence_s) {
    if (!has_ignored_) ignored_name_ = name;
    has_ignored_ = true;
    return false;
  }
  changes_ += is_other && !is_first ? 1 : 0;
  name_ = name;
  heard_s_ = received_s;
  return true;
}

void fill_tracker(const Tracks& tracks, const TrackerSource& source, double unix_s,
                  TrackerPacket& packet) {
  packet.Clear();
  packet.set_uuid(source.uuid);
  packet.set_source_name(source.name);
  TrackerFrame& tracked = *packet.mutable_tracked_frame();
  tracked.set_frame_number(static_cast<std::uint32_t>(tracks.frame));
  tracked.set_timestamp(unix_s);
  if (source.detects_flying_balls) tracked.add_capabilities(kDetectsFlyingBalls);
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : tracks.robots[side])
      fill_robot(robot, side, *tracked.add_robots());
  }
  if (tracks.ball) fill_ball(*tracks.ball, *tracked.add_balls());
}

double TrackFollower::time_of(double timestamp_s, double received_s) {
  const double step_s = timestamp_s + offset_s_ - frame_.time_s;
  const double elapsed_s = std::max(kStep_s, received_s - received_s_);
  if (frames_ == 0) {
    offset_s_ = -timestamp_s;
  } else if (changes_ != source_.changes() || std::abs(step_s) > kTrackerLeap_s + elapsed_s) {
    offset_s_ = frame_.time_s + elapsed_s - timestamp_s;
  }
  changes_ = source_.changes();
  return timestamp_s + offset_s_;
}

bool TrackFollower::add(const TrackerPacket& packet, double received_s) {
  if (!packet.has_tracked_frame()) return false;
  const TrackerFrame& tracked = packet.tracked_frame();
  constexpr double kLatest_s = 1e12;  // later times lose their milliseconds
  if (!is_within(tracked.timestamp(), kLatest_s)) {
    ++unusable_;
    return false;
  }
  if (!source_.follows(packet.uuid(), received_s)) return false;
  const double time_s = time_of(tracked.timestamp(), received_s);
  if ((frames_ > 0 && time_s <= frame_.time_s) || time_s > kLongestTrack_s) return false;
  received_s_ = received_s;
  frame_.number = tracks_.frame = frames_++;
  frame_.time_s = tracks_.time_s = time_s;
  take_robots(tracked);
  take_ball(tracked);
  return true;
}

// If a robot occurs twice, the first is used.
void TrackFollower::take_robots(const TrackerFrame& tracked) {
  PerSide<std::array<std::optional<TrackedRobot>, kMaxRobots>> found;
  for (const TrackerRobot& seen : tracked.robots()) {
    const std::optional<Side> side = side_of(seen.robot_id().team());
    if (!side || !seen.robot_id().has_id() || seen.robot_id().id() >= kMaxRobots) continue;
    std::optional<TrackedRobot>& robot = found[*side][seen.robot_id().id()];
    if (!robot) robot = robot_of(seen);
  }
  for (const Side side : kSides) {
    tracks_.robots[side].clear();
    frame_.robots[side].clear();
    for (const std::optional<TrackedRobot>& robot : found[side]) {
      if (!robot) continue;
      tracks_.robots[side].push_back(*robot);
      if (robot->is_seen)
        frame_.robots[side].push_back({robot->number, robot->position_m, robot->heading});
    }
  }
}

void TrackFollower::take_ball(const TrackerFrame& tracked) {
  std::optional<TrackedBall> best;
  double visibility = 0;
  const auto distance_m = [this](const TrackedBall& ball) {
    return tracks_.ball ? (ball.position_m - tracks_.ball->position_m).norm() : 0;
  };
  for (const TrackerBall& seen : tracked.balls()) {
    const std::optional<TrackedBall> ball = ball_of(seen);
    const double seen_visibility = visibility_of(seen);
    if (!ball || std::isnan(seen_visibility)) continue;
    const bool is_better = !best || seen_visibility > visibility ||
                           (seen_visibility == visibility && distance_m(*ball) < distance_m(*best));
    if (!is_better) continue;
    best = ball;
    visibility = seen_visibility;
  }
  frame_.ball.reset();
  if (!best) return;
  tracks_.ball = best;
  if (visibility > 0) frame_.ball = BallObservation{best->position_m, best->height_m, {}};
}

}  // namespace autoref::league
