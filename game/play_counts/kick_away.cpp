#include "game/play_counts/kick_away.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "game/play_counts/play_counts.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::game {
namespace {

// The distance rolled from `speed_mps` to rest, with deceleration a + k v. It is the integral of
// v dv / (a + k v), which is v / k - a / k^2 ln(1 + k v / a).
double rolled_m(double speed_mps, const sim::BallParameters& ball) {
  const double a = ball.roll_mps2;
  const double k = ball.roll_per_s;
  if (k * speed_mps < 1e-6 * a) return speed_mps * speed_mps / (2 * a);
  return speed_mps / k - a / (k * k) * std::log1p(k * speed_mps / a);
}

// The robot's velocity; zero if it has just been removed.
Vec2 velocity_mps(RobotId id, const sim::WorldState& now) {
  for (const sim::RobotState& robot : now.robots[id.side]) {
    if (robot.number == id.number) return robot.velocity_mps;
  }
  return {0, 0};
}

// The kick's path if it is that of a shot, otherwise nullopt.
std::optional<ShotPath> shot_path(const BallTrajectory& trajectory, const Field& field,
                                  Side kicker) {
  const double forward = -goal_sign(kicker);
  const double ahead_m = forward * trajectory.from_m().x();
  if (ahead_m < (kClearanceShare - 0.5) * field.length_m) return std::nullopt;
  const double advance = forward * trajectory.direction().x();
  if (advance <= 0 || ahead_m >= field.half_length_m()) return std::nullopt;
  // Length of the straight path up to the goal line.
  const double to_line_m = (field.half_length_m() - ahead_m) / advance;
  if (to_line_m > trajectory.reach_m() || trajectory.speed_mps(to_line_m) < kArrival_mps)
    return std::nullopt;
  const Vec2 crossing_m = trajectory.point_m(to_line_m);
  const double off_middle_m = std::abs(crossing_m.y());
  if (off_middle_m > field.half_goal_m() + kShotMiss_m) return std::nullopt;
  const bool is_on_target =
      off_middle_m < field.half_goal_m() &&
      trajectory.height_m(to_line_m) + kBallRadius_m < field.goal_opening_height_m;
  return ShotPath{crossing_m, trajectory.time_s(to_line_m), is_on_target};
}

std::optional<ShotSituation> shot_in(const sim::Touch& kick, const BallTrajectory& trajectory,
                                     const sim::WorldState& now, const Field& field) {
  const std::optional<ShotPath> path = shot_path(trajectory, field, kick.robot.side);
  if (!path) return std::nullopt;
  return shot_situation(kick, *path, now, field);
}

// The distance that can be travelled along a path before the coordinate leaves +-limit_m;
// `direction` is the path direction's component along that coordinate.
double inside_m(double from_m, double direction, double limit_m) {
  if (direction == 0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, (std::copysign(limit_m, direction) - from_m) / direction);
}

// The length of the path until the ball stops or leaves the field.
double length_on_field_m(const BallTrajectory& trajectory, const Field& field) {
  return std::min(
      {trajectory.reach_m(),
       inside_m(trajectory.from_m().x(), trajectory.direction().x(), field.half_length_m()),
       inside_m(trajectory.from_m().y(), trajectory.direction().y(), field.half_width_m())});
}

bool may_meet(const Vec2& mate_m, const BallTrajectory& trajectory, double length_m) {
  const double first_m = std::max(kShortestPass_m, trajectory.flight_m());
  if (first_m > length_m) return false;
  // Projects the team-mate onto the path. The team-mate can receive the ball if, at a limited
  // speed, it can reach the nearest point of the path before the ball does.
  const double along_m = (mate_m - trajectory.from_m()).dot(trajectory.direction());
  if (along_m < kShortestPass_m) return false;
  const double meets_m = std::clamp(along_m, first_m, length_m);
  if (trajectory.speed_mps(meets_m) < kArrival_mps) return false;
  const double allowed_m =
      std::clamp(kMate_mps * trajectory.time_s(meets_m), kPassMiss_m, kFarthestMate_m);
  return (mate_m - trajectory.point_m(meets_m)).norm() <= allowed_m;
}

bool is_for_mate(const BallTrajectory& trajectory, const Field& field, RobotId kicker,
                 const sim::WorldState& now) {
  const double length_m = length_on_field_m(trajectory, field);
  const auto& mates = now.robots[kicker.side];
  return std::any_of(mates.begin(), mates.end(), [&](const sim::RobotState& mate) {
    return mate.number != kicker.number && may_meet(mate.position_m, trajectory, length_m);
  });
}

}  // namespace

BallTrajectory::BallTrajectory(const Vec2& from_m, const Vec2& velocity_mps, double vertical_mps,
                               const sim::BallParameters& ball)
    : from_m_(from_m), direction_(direction_of(velocity_mps, {1, 0})), vertical_mps_(vertical_mps) {
  const double kick_mps = velocity_mps.norm();
  double rolls_mps = ball.switch_ratio * kick_mps;
  if (vertical_mps > 0) {
    flight_m_ = kick_mps * 2 * vertical_mps / kGravity_mps2;
    phases_[0] = {kick_mps, 0, flight_m_};
    rolls_mps = ball.hop_first_xy * kick_mps;
  } else {
    const double slides_m = (kick_mps * kick_mps - rolls_mps * rolls_mps) / (2 * ball.slide_mps2);
    phases_[0] = {kick_mps, ball.slide_mps2, slides_m};
  }
  phases_[1] = {rolls_mps, ball.roll_mps2, rolled_m(rolls_mps, ball)};
  if (ball.roll_per_s > 0)
    phases_[1].slowing_mps2 = rolls_mps * rolls_mps / (2 * phases_[1].length_m);
}

double BallTrajectory::Phase::speed_at_mps(double path_m) const {
  return std::sqrt(std::max(0.0, speed_mps * speed_mps - 2 * slowing_mps2 * path_m));
}

// With constant deceleration, the mean speed is the average of the first and the last one.
double BallTrajectory::Phase::time_at_s(double path_m) const {
  return path_m <= 0 ? 0 : 2 * path_m / (speed_mps + speed_at_mps(path_m));
}

double BallTrajectory::speed_mps(double path_m) const {
  const double first_m = phases_[0].length_m;
  return path_m < first_m ? phases_[0].speed_at_mps(path_m)
                          : phases_[1].speed_at_mps(path_m - first_m);
}

double BallTrajectory::time_s(double path_m) const {
  const double first_m = std::min(path_m, phases_[0].length_m);
  return phases_[0].time_at_s(first_m) + phases_[1].time_at_s(path_m - first_m);
}

double BallTrajectory::height_m(double path_m) const {
  if (path_m >= flight_m_) return 0;
  const double flown_s = phases_[0].time_at_s(path_m);
  return vertical_mps_ * flown_s - kGravity_mps2 * flown_s * flown_s / 2;
}

std::optional<KickAway> kick_away(const sim::Touch& kick, const sim::WorldState& now,
                                  const Field& field, const sim::BallParameters& ball) {
  if ((kick.ball_mps - velocity_mps(kick.robot, now)).norm() < kAway_mps) return std::nullopt;
  const BallTrajectory trajectory(kick.ball_m, kick.ball_mps, kick.vertical_mps, ball);
  return KickAway{kick.robot, kick.frame, kick.ball_m, shot_in(kick, trajectory, now, field),
                  is_for_mate(trajectory, field, kick.robot, now)};
}

}  // namespace autoref::game
