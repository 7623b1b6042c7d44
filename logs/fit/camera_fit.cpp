#include "logs/fit/camera_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "logs/fit/rest_drift.hpp"
#include "logs/fit/sights.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

// The distances at which the ten games of 2026 were measured (sim/README.md).
constexpr std::array kSeenAt_m = {0.09, 0.11, 0.13, 0.15, 0.19, 0.25};

constexpr double kBlock_s = 10;
constexpr double kLongestThree = 3.5;  // median intervals that three intervals last at most
constexpr double kAwayFromRobots_m = 150_mm;

// A robot stands still in a window of frames if the mean pose of the first few of them is so near
// to that of the last few.
constexpr std::size_t kStillFrames = 15;
constexpr std::size_t kStillEnds = 5;
constexpr double kStill_m = 4_mm;
constexpr double kStill_rad = 0.02;

// Frames count if the ball was seen shortly before and afterwards, and not far from there.
constexpr double kFarthestBetween_m = 100_mm;
constexpr double kBehindGoalLine_m = 100_mm;  // goals may hide the ball behind this
constexpr double kHidingMargin_m = 20_mm;     // for noise, and balls between detections
constexpr double kGapBin_m = 10_mm;
constexpr double kSeenBin_m = 20_mm;

// False balls appear around this spot ahead of a robot's centre.
constexpr double kFalseBallAhead_m = 130_mm;
constexpr double kHalfFalseBallLength_m = 30_mm;
constexpr double kHalfFalseBallWidth_m = 20_mm;
constexpr double kOwnBall_m = 120_mm;  // balls in the area may be real if the ball is nearer

std::vector<std::size_t> frames_with(const auto& sights) {
  std::vector<std::size_t> seen;
  seen.reserve(sights.size());
  for (std::size_t i = 0; i < sights.size(); ++i) {
    if (sights[i].is_seen) seen.push_back(i);
  }
  return seen;
}

const CameraPosition& nearest_camera(const RecordedMotion& motion, const Vec2& position_m) {
  const auto away_m = [&](const auto& camera) {
    return (camera.second.position_m - position_m).norm();
  };
  return std::min_element(motion.cameras.begin(), motion.cameras.end(),
                          [&](const auto& a, const auto& b) { return away_m(a) < away_m(b); })
      ->second;
}

// Whether a robot hides the ball from the nearest camera, or would if it were a little larger.
bool may_be_hidden(const RecordedMotion& motion, std::size_t frame, const Vec2& ball_m) {
  const CameraPosition& camera = nearest_camera(motion, ball_m);
  const double over_robots =
      (kRobotHeight_m - kBallRadius_m) / std::max(camera.height_m - kBallRadius_m, kRobotHeight_m);
  const Vec2 end_m = ball_m + over_robots * (camera.position_m - ball_m);
  return std::any_of(motion.robots.begin(), motion.robots.end(), [&](const RobotMotion& robot) {
    const RobotSight& sight = robot.sights[frame];
    if (!sight.is_known ||
        distance_to_segment(sight.position_m, ball_m, end_m) > kRobotRadius_m + kHidingMargin_m)
      return false;
    const Vec2 heading = heading_of(sight.heading_rad);
    const auto is_in_front = [&](const Vec2& point_m) {
      return (point_m - sight.position_m).dot(heading) > kFrontDistance_m + kHidingMargin_m / 2;
    };
    return !is_in_front(ball_m) || !is_in_front(end_m);
  });
}

// From the ball to the centre of the nearest robot; infinite if none is known.
double nearest_robot_m(const RecordedMotion& motion, std::size_t frame, const Vec2& ball_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const RobotMotion& robot : motion.robots) {
    const RobotSight& sight = robot.sights[frame];
    if (sight.is_known) nearest_m = std::min(nearest_m, (sight.position_m - ball_m).norm());
  }
  return nearest_m;
}

bool is_in_view(const Field& field, const Vec2& ball_m) {
  return std::abs(ball_m.x()) < field.half_length_m() + kBehindGoalLine_m &&
         std::abs(ball_m.y()) < field.wall_y_m();
}

// Where a false ball of this robot would be.
Vec2 false_ball_spot_m(const RobotSight& robot) {
  return robot.position_m + kFalseBallAhead_m * heading_of(robot.heading_rad);
}

// Whether balls around that spot must be false, as the ball is elsewhere.
bool can_have_false_ball(const RecordedMotion& motion, const RobotMotion& robot,
                         std::size_t frame) {
  const RobotSight& sight = robot.sights[frame];
  return sight.is_known && motion.ball[frame].is_seen &&
         (false_ball_spot_m(sight) - motion.ball[frame].position_m).norm() > kOwnBall_m;
}

bool is_false_ball_of(const RobotSight& robot, const Vec2& ball_m) {
  const Vec2 off_m = to_local(ball_m - false_ball_spot_m(robot), heading_of(robot.heading_rad));
  return std::abs(off_m.x()) < kHalfFalseBallLength_m &&
         std::abs(off_m.y()) < kHalfFalseBallWidth_m;
}

}  // namespace

CameraFit::CameraFit() {
  for (const double distance_m : kSeenAt_m) ball_seen_.push_back({distance_m});
}

void CameraFit::add(const RecordedMotion& motion) {
  first_block_ = blocks_.size();
  add_intervals(motion);
  add_ball_noise(motion);
  add_ball_sights(motion);
  add_false_balls(motion);
  const auto append = [](std::vector<double>& to, const std::vector<double>& values) {
    to.insert(to.end(), values.begin(), values.end());
  };
  append(ball_drifts_m2_, ball_drifts_m2(motion));
  for (const RobotMotion& robot : motion.robots) {
    add_still_robots(motion, robot);
    add_robot_sights(motion, robot);
    append(robot_drifts_m2_, robot_drifts_m2(motion, robot));
  }
}

CameraFit::Block& CameraFit::block_at(const RecordedMotion& motion, std::size_t frame) {
  const double since_s = motion.times_s[frame] - motion.times_s.front();
  const std::size_t block = first_block_ + static_cast<std::size_t>(since_s / kBlock_s);
  if (block >= blocks_.size()) blocks_.resize(block + 1);
  return blocks_[block];
}

void CameraFit::add_intervals(const RecordedMotion& motion) {
  for (std::size_t i = 1; i < motion.frames(); ++i)
    block_at(motion, i).intervals_s.push_back(motion.times_s[i] - motion.times_s[i - 1]);
}

void CameraFit::add_ball_noise(const RecordedMotion& motion) {
  const std::span ball(motion.ball);
  for (std::size_t i = 0; i + kThirdDifferenceValues <= motion.frames();
       i += kThirdDifferenceValues) {
    const std::size_t last = i + kThirdDifferenceValues - 1;
    const auto four = ball.subspan(i, kThirdDifferenceValues);
    if (!is_seen_by_one_camera(four) || motion.nearest_m[i] < kAwayFromRobots_m ||
        motion.nearest_m[last] < kAwayFromRobots_m ||
        motion.times_s[last] - motion.times_s[i] > kLongestThree * motion.interval_s)
      continue;
    const Vec2 difference_m = third_difference_m(four).cwiseAbs();
    auto& differences_m = block_at(motion, i).ball_differences_m;
    differences_m.insert(differences_m.end(), {difference_m.x(), difference_m.y()});
  }
}

void CameraFit::add_still_robots(const RecordedMotion& motion, const RobotMotion& robot) {
  const auto mean_of = [](std::span<const RobotSight> sights) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const RobotSight& sight : sights)
      sum += Eigen::Vector3d(sight.position_m.x(), sight.position_m.y(), sight.heading_rad);
    return Eigen::Vector3d(sum / static_cast<double>(sights.size()));
  };
  for (std::size_t i = 0; i + kStillFrames <= motion.frames(); i += kStillFrames) {
    const auto window = std::span(robot.sights).subspan(i, kStillFrames);
    if (!is_seen_by_one_camera(window) ||
        motion.times_s[i + kStillFrames - 1] - motion.times_s[i] >
            static_cast<double>(kStillFrames + 1) * motion.interval_s)
      continue;
    const Eigen::Vector3d moved =
        mean_of(window.last(kStillEnds)) - mean_of(window.first(kStillEnds));
    if (moved.head<2>().norm() > kStill_m || std::abs(moved.z()) > kStill_rad) continue;
    StillRobot still;
    constexpr std::size_t kDifferences = kStillFrames - kThirdDifferenceValues + 1;
    for (std::size_t k = 0; k < kDifferences; ++k) {
      const auto four = window.subspan(k, kThirdDifferenceValues);
      still.noise_m2 += third_difference_m(four).squaredNorm() / 2;
      still.noise_rad2 += square(third_difference(four[0].heading_rad, four[1].heading_rad,
                                                  four[2].heading_rad, four[3].heading_rad));
    }
    still.noise_m2 /= kDifferences * kThirdDifferenceVariance;
    still.noise_rad2 /= kDifferences * kThirdDifferenceVariance;
    block_at(motion, i).still_robots.push_back(still);
  }
}

// Whether a frame counts, and as near which robot, depends on the sights before and after it alone,
// so that frames with the ball and frames without it are treated alike.
void CameraFit::add_ball_sights(const RecordedMotion& motion) {
  const std::vector<std::size_t> seen = frames_with(motion.ball);
  if (seen.empty()) return;
  std::size_t next = 0;  // sight after the frame
  for (std::size_t i = seen.front() + 1; i < seen.back(); ++i) {
    while (seen[next] <= i) ++next;
    const std::size_t after = seen[next];
    const std::size_t before = seen[next - (motion.ball[i].is_seen ? 2 : 1)];
    const double span_s = motion.times_s[after] - motion.times_s[before];
    const Vec2 moved_m = motion.ball[after].position_m - motion.ball[before].position_m;
    if (span_s > RecordedMotion::kLongestGap_s || moved_m.norm() > kFarthestBetween_m ||
        std::binary_search(motion.spikes.begin(), motion.spikes.end(), i))
      continue;
    const double share = (motion.times_s[i] - motion.times_s[before]) / span_s;
    count_ball(motion, i, motion.ball[before].position_m + share * moved_m);
  }
}

void CameraFit::count_ball(const RecordedMotion& motion, std::size_t frame, const Vec2& ball_m) {
  if (!is_in_view(motion.field, ball_m)) return;
  const bool is_seen = motion.ball[frame].is_seen;
  const double nearest_m = nearest_robot_m(motion, frame, ball_m);
  for (SeenShare& share : ball_seen_) {
    if (std::abs(nearest_m - share.distance_m) > kSeenBin_m / 2) continue;
    ++share.frames;
    share.seen += is_seen ? 1 : 0;
  }
  constexpr double kWidest_m = kGapBin_m * (kGapBins - 1);
  const double gap_m = std::clamp(nearest_m - kRobotRadius_m, 0.0, kWidest_m);
  const auto index = static_cast<std::size_t>(gap_m / kGapBin_m);
  if (index < kFarBin && (motion.cameras.empty() || may_be_hidden(motion, frame, ball_m))) return;
  GapBin& bin = block_at(motion, frame).gaps[std::min(index, kGapBins - 1)];
  ++bin.frames;
  bin.missed += is_seen ? 0 : 1;
  bin.sum_m += gap_m;
}

void CameraFit::add_robot_sights(const RecordedMotion& motion, const RobotMotion& robot) {
  const std::vector<std::size_t> seen = frames_with(robot.sights);
  for (std::size_t k = 0; k + 1 < seen.size(); ++k) {
    if (motion.times_s[seen[k + 1]] - motion.times_s[seen[k]] > RecordedMotion::kLongestGap_s)
      continue;
    const std::size_t run = seen[k + 1] - seen[k] - 1;
    RobotCounts& counts = block_at(motion, seen[k]).robots;
    counts.frames += static_cast<double>(run + 1);
    counts.missed += static_cast<double>(run);
    if (run < std::size_t{kLongRun}) continue;
    ++counts.long_runs;
    counts.missed_in_long_runs += static_cast<double>(run);
  }
}

// Only frames with the ball count, as a false ball may be taken for a ball that is not seen.
void CameraFit::add_false_balls(const RecordedMotion& motion) {
  for (std::size_t i = 0; i < motion.frames(); ++i) {
    const auto robots = std::count_if(
        motion.robots.begin(), motion.robots.end(),
        [&](const RobotMotion& robot) { return can_have_false_ball(motion, robot, i); });
    block_at(motion, i).false_balls.robots_s += static_cast<double>(robots) * motion.interval_s;
  }
  for (const OtherBall& ball : motion.other_balls) {
    const bool is_false =
        std::any_of(motion.robots.begin(), motion.robots.end(), [&](const RobotMotion& robot) {
          return can_have_false_ball(motion, robot, ball.frame) &&
                 is_false_ball_of(robot.sights[ball.frame], ball.position_m);
        });
    if (is_false) ++block_at(motion, ball.frame).false_balls.count;
  }
}

}  // namespace autoref::logs
