#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "logs/fit/bounces.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kNearWall_m = 0.25;
constexpr std::size_t kVisitGap_frames = 12;  // a longer absence separates visits to the wall
constexpr std::size_t kSearched_frames = 25;
constexpr double kSearched_s = 0.18;
constexpr std::size_t kMostWallSights = 10;
constexpr double kBeforeWall_m = 15_mm;  // closer balls may already bounce
constexpr double kAfterWall_s = 3_ms;
constexpr double kLongestUnseenAtWall_s = 60_ms;
constexpr double kSlowestIntoWall_mps = 0.8;
constexpr double kWallUneven_m = 0.8_mm;   // errors of vision and wall that noise does not show
constexpr double kWorstBeforeWall = 2.0;   // residual in standard deviations
constexpr double kWorstAfterWall = 2.5;    // the same
constexpr double kLongestSliding_s = 0.3;  // after the bounce
constexpr int kSlidingSteps = 30;
constexpr double kBesideGoal_m = 80_mm;  // farther inwards, the ball meets the goal's walls
constexpr double kRobotAway_m = 0.2;     // closer robots may touch the ball
constexpr std::size_t kRobotAwayBefore_frames = 8;
constexpr std::size_t kRobotAwayAfter_frames = 12;

// A wall across x or y (`axis` 0 or 1), at `limit_m` from the field's middle for the ball's centre.
struct Wall {
  int axis = 0;
  double sign = 1;
  double limit_m = 0;

  // How far the ball's surface is from the wall.
  double distance_m(const Vec2& ball_m) const { return limit_m - sign * ball_m[axis]; }
};

double wall_noise_m(const RecordedMotion& motion) {
  return std::hypot(motion.ball_noise_m, kWallUneven_m);
}

// The path of the ball before it meets the wall; times count from frame `turn`, in which it is
// closest. The ball rolls, so what it has lost by then is subtracted from its speed.
std::optional<Line> path_to_wall(const RecordedMotion& motion, const Wall& wall, std::size_t turn,
                                 const sim::BallParameters& ball) {
  Points points;
  const double turn_s = motion.ball[turn].time_s;
  const std::size_t earliest = turn - std::min(turn, kSearched_frames);
  for (std::size_t f = turn + 1; f-- > earliest && points.size() < kMostWallSights;) {
    const BallSight& sight = motion.ball[f];
    if (turn_s - sight.time_s > kSearched_s) break;
    if (sight.is_seen && wall.distance_m(sight.position_m) > kBeforeWall_m)
      points.add(sight.time_s - turn_s, sight.position_m, wall_noise_m(motion));
  }
  if (points.size() < kLeastBounceSights) return std::nullopt;
  const Vec2 velocity_mps = straight_line_through(points).velocity_mps;
  const Vec2 loss_mps2 =
      ball.roll_mps2 * direction_of(velocity_mps, {0, 0}) + ball.roll_per_s * velocity_mps;
  for (std::size_t i = 0; i < points.size(); ++i)
    points.positions_m[i] += loss_mps2 / 2 * square(points.times_s[i]);
  const Line line = straight_line_through(points);
  if (line.residual <= kWorstBeforeWall) return line;
  return std::nullopt;
}

// Distances of the ball from a wall at times after it met the wall.
struct Departure {
  std::vector<double> times_s;
  std::vector<double> distances_m;
};

Departure departure_from(const RecordedMotion& motion, const Wall& wall, std::size_t turn,
                         double contact_s) {
  Departure departure;
  const std::size_t end = std::min(turn + kSearched_frames, motion.frames());
  for (std::size_t f = turn; f < end && departure.times_s.size() < kMostWallSights; ++f) {
    const BallSight& ball = motion.ball[f];
    if (ball.time_s - motion.ball[turn].time_s > kSearched_s) break;
    const double since_s = ball.time_s - contact_s;
    if (!ball.is_seen || since_s <= kAfterWall_s) continue;
    departure.times_s.push_back(since_s);
    departure.distances_m.push_back(wall.distance_m(ball.position_m));
  }
  return departure;
}

// The speed at which the ball leaves the wall, or nullopt if it does not move as a ball that first
// slides, then rolls. How long it slides depends on its spin, so several durations are tried.
std::optional<double> departing_mps(const Departure& departure, const sim::BallParameters& ball,
                                    double noise_m) {
  const std::size_t count = departure.times_s.size();
  double least_m2 = static_cast<double>(count - 2) * square(kWorstAfterWall * noise_m);
  std::optional<double> best_mps;
  std::vector<double> undone_m(count);  // distances as they would be without friction
  for (int step = 0; step <= kSlidingSteps; ++step) {
    const double sliding_s = kLongestSliding_s * step / kSlidingSteps;
    double products = 0;
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double slid_s = std::min(departure.times_s[i], sliding_s);
      const double rolled_s = departure.times_s[i] - slid_s;
      undone_m[i] = departure.distances_m[i] + ball.slide_mps2 * slid_s * (slid_s / 2 + rolled_s) +
                    ball.roll_mps2 * square(rolled_s) / 2;
      products += departure.times_s[i] * undone_m[i];
      squares += square(departure.times_s[i]);
    }
    const double speed_mps = products / squares;
    if (speed_mps < ball.slide_mps2 * sliding_s) break;
    double sum_m2 = 0;
    for (std::size_t i = 0; i < count; ++i)
      sum_m2 += square(undone_m[i] - speed_mps * departure.times_s[i]);
    if (sum_m2 > least_m2) continue;
    least_m2 = sum_m2;
    best_mps = speed_mps;
  }
  return best_mps;
}

std::optional<Bounce> wall_bounce(const RecordedMotion& motion, const Wall& wall,
                                  const Stretch& visit, const sim::BallParameters& ball) {
  std::size_t turn = visit.first;
  for (std::size_t f = visit.first; f <= visit.last; ++f)
    if (motion.ball[f].is_seen &&
        wall.distance_m(motion.ball[f].position_m) < wall.distance_m(motion.ball[turn].position_m))
      turn = f;
  const Vec2& turn_m = motion.ball[turn].position_m;
  if (wall.axis == 0 && std::abs(turn_m.y()) < motion.field.half_goal_m() + kBesideGoal_m)
    return std::nullopt;
  const std::size_t from = turn - std::min(turn, kRobotAwayBefore_frames);
  const std::size_t to = std::min(turn + kRobotAwayAfter_frames, motion.frames());
  for (std::size_t f = from; f < to; ++f)
    if (motion.nearest_m[f] < kRobotAway_m) return std::nullopt;
  const auto before = path_to_wall(motion, wall, turn, ball);
  if (!before) return std::nullopt;
  const double closing_mps = wall.sign * before->velocity_mps[wall.axis];
  if (closing_mps < kSlowestIntoWall_mps) return std::nullopt;
  const double contact_s =
      motion.ball[turn].time_s + wall.distance_m(before->position_m) / closing_mps;
  const Departure after = departure_from(motion, wall, turn, contact_s);
  if (after.times_s.size() < kLeastBounceSights || after.times_s[0] > kLongestUnseenAtWall_s)
    return std::nullopt;
  const auto leaving_mps = departing_mps(after, ball, wall_noise_m(motion));
  if (!leaving_mps) return std::nullopt;
  return bounce_of(closing_mps, *leaving_mps);
}

}  // namespace

std::vector<Bounce> wall_bounces_in(const RecordedMotion& motion, const sim::BallParameters& ball) {
  std::vector<Bounce> bounces;
  for (const double sign : {1.0, -1.0}) {
    for (const Wall& wall : {Wall{0, sign, motion.field.wall_x_m() - kBallRadius_m},
                             Wall{1, sign, motion.field.wall_y_m() - kBallRadius_m}}) {
      const auto is_near = [&](std::size_t f) {
        return motion.ball[f].is_seen && wall.distance_m(motion.ball[f].position_m) < kNearWall_m;
      };
      for (const Stretch& visit : stretches_of(motion.frames(), kVisitGap_frames, is_near)) {
        const auto bounce = wall_bounce(motion, wall, visit, ball);
        if (bounce) bounces.push_back(*bounce);
      }
    }
  }
  return bounces;
}

}  // namespace autoref::logs
