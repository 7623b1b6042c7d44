#include "logs/fit/seen_frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "logs/fit/estimate.hpp"
#include "logs/fit/sights.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

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

void interpolate_robot(std::vector<RobotSight>& sights) {
  std::size_t before = sights.size();
  for (std::size_t i = 0; i < sights.size(); ++i) {
    if (!sights[i].is_seen) continue;
    sights[i].is_known = true;
    if (before < i) {
      const double span_s = sights[i].time_s - sights[before].time_s;
      const bool is_short = span_s <= RecordedMotion::kLongestGap_s;
      for (std::size_t k = before + 1; k < i; ++k) {
        const RobotSight& from = sights[before];
        const double share = (sights[k].time_s - from.time_s) / span_s;
        sights[k] = {from.position_m + share * (sights[i].position_m - from.position_m),
                     from.heading_rad + share * (sights[i].heading_rad - from.heading_rad),
                     from.camera,
                     false,
                     is_short,
                     sights[k].time_s};
      }
    }
    before = i;
  }
}

RobotMotion robot_motion(const RobotId& id, const std::vector<SeenFrame>& frames) {
  RobotMotion motion{id, std::vector<RobotSight>(frames.size())};
  RobotSight last;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    motion.sights[i].time_s = frames[i].time_s;
    const SeenRobot* seen = chosen_robot(frames[i], id, last);
    if (seen == nullptr) continue;
    const double heading_rad =
        last.is_seen ? last.heading_rad + wrapped_rad(seen->heading_rad - last.heading_rad)
                     : seen->heading_rad;
    last = {seen->position_m, heading_rad, seen->camera, true, true, seen->time_s};
    motion.sights[i] = last;
  }
  interpolate_robot(motion.sights);
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
      motion.robots.push_back(robot_motion({id.first, id.second}, frames));
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

}  // namespace

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

}  // namespace autoref::logs
