#include "referee/touch/kept_touch.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/touch_candidates.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr double kAtRobot_m = 20_mm;
constexpr double kAlone_m = 400_mm;  // distance from the ball to the centre of the nearest opponent
constexpr double kSurelyApartDeviations = 3;
// A ball slower than this shows neither where it is going nor where it comes from.
constexpr double kMoves_mps = 0.5_mps;
constexpr double kMovedOn_m = 150_mm;
// Distance from the ball before the gap to its path after the gap.
constexpr double kBesidePath_m = 150_mm;
constexpr double kStraight = 0.1;  // change of direction, in radians
constexpr double kFaster = 1.05;   // carpets slow a ball down; the rest is noise
// Conservative fits of how the percentages in the header fall towards 50.
constexpr double kStraightLasts_s = 10;
constexpr double kHolderLasts_s = 2;

double kept_over(double gap_s, double lasts_s) { return (1 + exponential(-gap_s / lasts_s)) / 2; }

// The mean velocity over the newest detections, except the last `back` ones.
Vec2 velocity_mps(const FrameHistory& frames, int back) {
  const int oldest =
      static_cast<int>(std::min<std::int64_t>(back + kDetectionsAtGap, frames.detections())) - 1;
  if (oldest <= back) return Vec2(0, 0);
  const BallDetection& now = frames.detection(back).ball;
  const BallDetection& before = frames.detection(oldest).ball;
  return (now.position_m - before.position_m) / (now.time_s - before.time_s);
}

bool is_alone(const StoredFrame& frame, Side side) {
  const SeenRobots& opponents = frame.robots[opponent_of(side)];
  return std::all_of(opponents.begin(), opponents.end(), [&frame](const RobotObservation& robot) {
    return (robot.position_m - frame.ball.position_m).norm() > kAlone_m;
  });
}

void find_holder(const StoredFrame& frame, double noise_m, BeforeGap& before) {
  int count = 0;
  for (const Side side : kSides) {
    for (const RobotObservation& robot : frame.robots[side]) {
      const double gap_m = gap_to_robot_m(robot, frame.ball.position_m);
      if (!(gap_m <= kAtRobot_m + kSurelyApartDeviations * noise_m)) continue;
      ++count;
      before.holder = RobotId{side, robot.number};
      before.holder_gap_m = std::max(0.0, gap_m);
    }
  }
  if (count != 1 || !is_alone(frame, before.holder->side)) before.holder.reset();
}

// Whether a ball that was at `from_m` may have taken this path through `now_m` within that time.
bool leads_from(const Vec2& from_m, const Vec2& now_m, const Vec2& now_mps, double within_s) {
  const Vec2 path_m = now_m - from_m;
  const double speed_mps = now_mps.norm();
  return speed_mps > kMoves_mps && path_m.norm() > kMovedOn_m && path_m.dot(now_mps) > 0 &&
         std::abs(cross(path_m, now_mps)) < kBesidePath_m * speed_mps &&
         path_m.norm() <= kFaster * within_s * speed_mps;
}

bool goes_straight_on(const BeforeGap& before, const Vec2& now_mps) {
  const double before_mps = before.velocity_mps.norm();
  return before_mps > kMoves_mps && now_mps.norm() <= kFaster * before_mps &&
         (before.velocity_mps / before_mps - now_mps.normalized()).norm() < kStraight;
}

}  // namespace

BeforeGap before_gap(const FrameHistory& frames, int back, const LastTouch& last, double noise_m) {
  const StoredFrame& frame = frames.detection(back);
  BeforeGap before;
  before.last = last;
  before.time_s = frame.ball.time_s;
  before.position_m = frame.ball.position_m;
  before.velocity_mps = velocity_mps(frames, back);
  find_holder(frame, noise_m, before);
  return before;
}

std::optional<LastTouch> kept_touch(const BeforeGap& before, const FrameHistory& frames) {
  const BallDetection& now = frames.detection(0).ball;
  const double gap_s = frames.detection(kDetectionsAtGap - 1).ball.time_s - before.time_s;
  const Vec2 now_mps = velocity_mps(frames, 0);
  const double since_s = now.time_s - before.time_s;
  if (before.holder) {
    if (!leads_from(before.position_m, now.position_m, now_mps, since_s)) return std::nullopt;
    LastTouch touch;
    touch.side = before.holder->side;
    touch.robot = before.holder;
    touch.time_s = before.time_s;
    touch.gap_m = before.holder_gap_m;
    touch.kept = kept_over(gap_s, kHolderLasts_s);
    return touch;
  }
  // A ball that only rolls is slower at the end, so it takes longer for its path than its last
  // speed suggests.
  const double unbraked_s = since_s * before.velocity_mps.norm() / std::max(now_mps.norm(), 1e-9);
  if (!before.last.side || !goes_straight_on(before, now_mps) ||
      !leads_from(before.position_m, now.position_m, now_mps, unbraked_s)) {
    return std::nullopt;
  }
  LastTouch touch = before.last;
  // Possession may pass to the other team in either gap, or in both.
  touch.kept = 0.5 + 2 * (touch.kept - 0.5) * (kept_over(gap_s, kStraightLasts_s) - 0.5);
  return touch;
}

}  // namespace autoref::referee
