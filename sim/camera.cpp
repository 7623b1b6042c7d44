#include "sim/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {
namespace {

// Of the four cameras, 0 and 3 are diagonally opposite each other, and so are 1 and 2.
double sign_of(int camera) { return camera == 0 || camera == 3 ? 1.0 : -1.0; }

double drawn_angle(RandomStream& chance) { return 2.0 * kPi * chance.uniform(); }

double as_float_mm(double metres) {
  return static_cast<double>(static_cast<float>(metres * 1000.0)) / 1000.0;
}

Vec2 rounded(const Vec2& position_m) {
  return {as_float_mm(position_m.x()), as_float_mm(position_m.y())};
}

Vec2 rounded_heading(const Vec2& heading, double noise_rad) {
  return heading_of(static_cast<double>(static_cast<float>(angle_of(heading) + noise_rad)));
}

// The parallax of a flying ball: the camera reports the point where its ray through the ball's
// centre intersects the plane of the centre of a ball on the carpet.
Vec2 seen_before_carpet(const BallState& ball, const CameraPosition& camera) {
  const double below_m = camera.height_m - kBallRadius_m;
  return camera.position_m +
         (ball.position_m - camera.position_m) * (below_m / (below_m - ball.height_m));
}

bool is_hidden(const WorldState& world, const CameraPosition& camera) {
  const BallState& ball = world.ball;
  const auto hides = [&](const RobotState& robot) {
    return hides_ball(robot, ball.position_m, ball.height_m, camera);
  };
  return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
    return std::any_of(world.robots[side].begin(), world.robots[side].end(), hides);
  });
}

// Distance of a false ball from the centre of a robot, straight ahead (measured at RoboCup 2026).
constexpr double kNearestFalseBall_m = 0.12;
constexpr double kFarthestFalseBall_m = 0.14;

// A ball that moves farther between two frames was placed elsewhere: at 8 m/s, the maximum, it
// moves by 0.27 m at 30 frames per second.
constexpr double kFarthestInFrame_m = 0.3;

// The square of the distance from the ball to the centre of the nearest robot.
double nearest_robot_m2(const WorldState& world) {
  double nearest_m2 = std::numeric_limits<double>::infinity();
  for (const Side side : kSides) {
    for (const RobotState& robot : world.robots[side]) {
      nearest_m2 = std::min(nearest_m2, (robot.position_m - world.ball.position_m).squaredNorm());
    }
  }
  return nearest_m2;
}

}  // namespace

CameraErrors::CameraErrors(const VisionParameters& parameters, const Field& field,
                           RandomStream& chance)
    : error_m_(parameters.camera_error_m),
      error_rad_(parameters.camera_error_rad),
      waves_per_m_(2.0 * kPi / field.length_m, 2.0 * kPi / field.width_m) {
  if (are_zero()) return;
  const double half_square = std::sqrt(0.5);
  offset_m_ = heading_of(drawn_angle(chance)) * (error_m_ * half_square);
  phases_rad_.x() = drawn_angle(chance);
  phases_rad_.y() = drawn_angle(chance);
  offset_rad_ = (chance.uniform() < 0.5 ? -1.0 : 1.0) * error_rad_ * half_square;
  heading_phase_rad_ = drawn_angle(chance);
}

// The mean of sin^2 over a period is 1/2, so together the two coordinates of the warp have the mean
// square error_m^2 / 2.
Vec2 CameraErrors::position_m(int camera, const Vec2& at_m) const {
  const Vec2 angles_rad = at_m.cwiseProduct(waves_per_m_) + phases_rad_;
  const Vec2 warp_m =
      Vec2(sin_cos(angles_rad.x()).sin, sin_cos(angles_rad.y()).sin) * (error_m_ * std::sqrt(0.5));
  return sign_of(camera) * (offset_m_ + warp_m);
}

double CameraErrors::heading_rad(int camera, const Vec2& at_m) const {
  const double angle_rad = at_m.x() * waves_per_m_.x() + heading_phase_rad_;
  return sign_of(camera) * (offset_rad_ + error_rad_ * sin_cos(angle_rad).sin);
}

CameraPositions camera_positions(const Field& field, int cameras, double height_m) {
  const double x = field.half_length_m() / 2.0;
  const double y = field.half_width_m() / 2.0;
  if (cameras == 1) return {CameraPosition{{0.0, 0.0}, height_m}};
  if (cameras == 2)
    return {CameraPosition{{-x, 0.0}, height_m}, CameraPosition{{x, 0.0}, height_m}};
  return {CameraPosition{{-x, -y}, height_m}, CameraPosition{{-x, y}, height_m},
          CameraPosition{{x, -y}, height_m}, CameraPosition{{x, y}, height_m}};
}

void draw_capture_ages(const VisionParameters& parameters, double frame_rate_hz, std::uint64_t seed,
                       std::span<CameraPosition> cameras) {
  if (!parameters.cameras_run_freely || parameters.reports_height) return;
  const double period_s = 1.0 / frame_rate_hz;
  auto chance = RandomStream::of(seed, RandomPurpose::kCameraPhases);
  std::array<double, CameraPositions::static_capacity> phases_s{};
  for (std::size_t i = 0; i < cameras.size(); ++i) phases_s[i] = chance.uniform() * period_s;
  // The age of one camera's capture at another's next capture.
  const auto age_s = [&](std::size_t camera, std::size_t at) {
    const double since_s = phases_s[at] - phases_s[camera];
    return since_s < 0.0 ? since_s + period_s : since_s;
  };
  const auto oldest_s = [&](std::size_t at) {
    double most_s = 0.0;
    for (std::size_t i = 0; i < cameras.size(); ++i) most_s = std::max(most_s, age_s(i, at));
    return most_s;
  };
  std::size_t last = 0;
  for (std::size_t i = 1; i < cameras.size(); ++i) {
    if (oldest_s(i) < oldest_s(last)) last = i;
  }
  for (std::size_t i = 0; i < cameras.size(); ++i) cameras[i].age_s = age_s(i, last);
}

bool hides_ball(const RobotState& robot, const Vec2& ball_m, double height_m,
                const CameraPosition& camera) {
  const double middle_m = height_m + kBallRadius_m;
  if (middle_m >= kRobotHeight_m) return false;
  // Only the part of the line of sight below the robots' tops can be blocked, so its projection
  // onto the carpet is tested against the hull.
  const double over_robots = (kRobotHeight_m - middle_m) / (camera.height_m - middle_m);
  return meets_hull(ball_m, ball_m + (camera.position_m - ball_m) * over_robots, robot.position_m,
                    robot.heading);
}

Camera::Camera(const VisionParameters& parameters, const Field& field, double frame_rate_hz,
               std::uint64_t seed)
    : parameters_(parameters),
      cameras_(camera_positions(field, parameters.cameras, parameters.camera_height_m)),
      sees_beside_m_(field.half_length_m() / 2.0 + parameters.camera_overlap_m,
                     field.half_width_m() / 2.0 + parameters.camera_overlap_m),
      frame_rate_hz_(frame_rate_hz),
      false_balls_(parameters.false_balls_per_s / frame_rate_hz),
      robot_gaps_(parameters.robot_gaps / ((1.0 - parameters.robot_gaps) *
                                           std::max(1.0, parameters.robot_gap_s * frame_rate_hz))),
      chance_(RandomStream::of(seed, RandomPurpose::kCamera)),
      errors_(parameters, field, chance_) {
  draw_capture_ages(parameters, frame_rate_hz, seed, {cameras_.data(), cameras_.size()});
}

void Camera::look(const WorldState& world, Frame& frame) {
  frame.number = world.frame;
  frame.time_s = static_cast<double>(world.frame) / frame_rate_hz_;
  if (!others_.is_empty()) others_ = {};
  look_at_robots(world, frame);
  look_at_ball(world, frame);
  if (false_balls_ > 0.0) look_for_false_balls(world, frame);
  if (parameters_.cameras_run_freely) former_ball_ = world.ball;
  ++looks_;
}

void Camera::look_at_robots(const WorldState& world, Frame& frame) {
  for (const Side side : kSides) {
    frame.robots[side].clear();
    SeenRobots misread;
    for (const RobotState& robot : world.robots[side]) {
      if (is_missed(side, robot)) continue;
      SeenRobots& seen = happens(parameters_.misread_numbers) ? misread : frame.robots[side];
      seen.push_back(observed(robot));
    }
    for (RobotObservation& robot : misread) {
      const auto& team = world.robots[side];
      robot.number = misread_number(robot.number, {team.data(), team.size()});
      add_misread(side, robot, frame);
    }
  }
}

// A gap lasts between one frame and twice the mean, with equal probability.
bool Camera::is_missed(Side side, const RobotState& robot) {
  const bool is_missed = happens(parameters_.robot_misses);
  if (robot_gaps_ <= 0.0) return is_missed;
  std::int64_t& gap_end = gap_ends_[side][static_cast<std::size_t>(robot.number)];
  if (looks_ < gap_end) return true;
  if (!happens(robot_gaps_)) return is_missed;
  const double mean = std::max(1.0, parameters_.robot_gap_s * frame_rate_hz_);
  gap_end = looks_ + 1 + static_cast<std::int64_t>(chance_.uniform() * (2.0 * mean - 1.0));
  return true;
}

// The number of another robot in the team; `number` if there is no other robot.
int Camera::misread_number(int number, std::span<const RobotState> team) {
  const auto others = static_cast<double>(team.size() - 1);
  if (others == 0.0) return number;
  const auto index = static_cast<std::size_t>(chance_.uniform() * others);
  return team[index].number < number ? team[index].number : team[index + 1].number;
}

RobotObservation Camera::observed(const RobotState& robot) {
  Vec2 position_m = with_noise(robot.position_m, parameters_.robot_noise_m);
  double noise_rad =
      parameters_.robot_noise_rad > 0.0 ? parameters_.robot_noise_rad * chance_.normal() : 0.0;
  if (!errors_.are_zero() || parameters_.cameras_run_freely) {
    const int camera = nearest_camera(robot.position_m);
    const double age_s = cameras_[static_cast<std::size_t>(camera)].age_s;
    position_m += errors_.position_m(camera, robot.position_m) - age_s * robot.velocity_mps;
    noise_rad +=
        errors_.heading_rad(camera, robot.position_m) - age_s * robot.angular_velocity_radps;
  }
  return {robot.number, rounded(position_m), rounded_heading(robot.heading, noise_rad)};
}

// If the robot with the misread number was also seen, that robot is in the frame.
void Camera::add_misread(Side side, const RobotObservation& robot, Frame& frame) {
  SeenRobots& robots = frame.robots[side];
  const auto at = std::lower_bound(robots.begin(), robots.end(), robot,
                                   [](const RobotObservation& one, const RobotObservation& other) {
                                     return one.number < other.number;
                                   });
  const bool is_double = at != robots.end() && at->number == robot.number;
  if (is_double) {
    others_.robots[side].push_back(robot);
  } else {
    robots.insert(at, robot);
  }
}

void Camera::look_at_ball(const WorldState& world, Frame& frame) {
  frame.ball.reset();
  if (happens(ball_misses(world))) return;
  const CameraPosition* camera = find_view(world);
  if (camera == nullptr) return;
  const BallState ball = captured_ball(world.ball, *camera);
  frame.ball.emplace();
  frame.ball->seen_from = *camera;
  Vec2 position_m = ball.position_m;
  if (parameters_.reports_height) {
    frame.ball->height_m = as_float_mm(ball.height_m);
  } else {
    position_m = seen_before_carpet(ball, *camera);
  }
  if (!errors_.are_zero()) {
    position_m += errors_.position_m(static_cast<int>(camera - cameras_.data()), position_m);
  }
  frame.ball->position_m = rounded(with_noise(position_m, parameters_.ball_noise_m));
}

// A ball above the robots is seen as well as one that is far from them.
double Camera::ball_misses(const WorldState& world) const {
  const double near = parameters_.ball_misses_near_robots;
  if (near <= 0.0 || world.ball.height_m > kRobotHeight_m) return parameters_.ball_misses;
  const double gap_m = std::sqrt(nearest_robot_m2(world)) - kRobotRadius_m;
  const double share = near * exponential(-std::max(0.0, gap_m) / parameters_.near_robots_m);
  return 1.0 - (1.0 - parameters_.ball_misses) * (1.0 - share);
}

// A kick may have changed the ball's velocity since the camera's capture, so the ball is where it
// was on the straight line between two frames.
BallState Camera::captured_ball(const BallState& ball, const CameraPosition& camera) const {
  if (camera.age_s <= 0.0 || !former_ball_) return ball;
  const Vec2 moved_m = ball.position_m - former_ball_->position_m;
  if (moved_m.norm() > kFarthestInFrame_m) return ball;
  const double share = camera.age_s * frame_rate_hz_;
  BallState captured = ball;
  captured.position_m -= share * moved_m;
  captured.height_m -= share * (ball.height_m - former_ball_->height_m);
  return captured;
}

void Camera::look_for_false_balls(const WorldState& world, Frame& frame) {
  for (const Side side : kSides) {
    for (const RobotState& robot : world.robots[side]) {
      if (!happens(false_balls_)) continue;
      const double ahead_m =
          kNearestFalseBall_m + (kFarthestFalseBall_m - kNearestFalseBall_m) * chance_.uniform();
      const Vec2 position_m = robot.position_m + ahead_m * robot.heading;
      const int camera = nearest_camera(position_m);
      BallObservation ball{rounded(position_m + errors_.position_m(camera, position_m)),
                           std::nullopt, cameras_[static_cast<std::size_t>(camera)]};
      if (parameters_.reports_height) ball.height_m = 0.0;
      add_ball(ball, frame);
    }
  }
  if (frame.ball) last_ball_m_ = frame.ball->position_m;
}

// If there is no ball in an earlier frame to compare with, the ball that is already in this frame
// stays in it.
void Camera::add_ball(BallObservation ball, Frame& frame) {
  if (!frame.ball) {
    frame.ball = ball;
    return;
  }
  if (others_.balls.size() == others_.balls.capacity()) return;
  const bool is_nearer = last_ball_m_ && (ball.position_m - *last_ball_m_).squaredNorm() <
                                             (frame.ball->position_m - *last_ball_m_).squaredNorm();
  if (is_nearer) std::swap(ball, *frame.ball);
  others_.balls.push_back(ball);
}

int Camera::nearest_camera(const Vec2& position_m) const {
  int nearest = 0;
  for (int i = 1; i < static_cast<int>(cameras_.size()); ++i) {
    const auto away_m2 = [&](int camera) {
      return (position_m - cameras_[static_cast<std::size_t>(camera)].position_m).squaredNorm();
    };
    if (away_m2(i) < away_m2(nearest)) nearest = i;
  }
  return nearest;
}

// The nearest camera with a clear view of the ball; nullptr if there is none.
const CameraPosition* Camera::find_view(const WorldState& world) const {
  const CameraPosition* nearest = nullptr;
  double nearest_m2 = 0.0;
  for (const CameraPosition& camera : cameras_) {
    if (!covers(camera, world.ball)) continue;
    const double away_m2 = (world.ball.position_m - camera.position_m).squaredNorm();
    if (nearest != nullptr && away_m2 >= nearest_m2) continue;
    if (parameters_.robots_hide_ball && is_hidden(world, camera)) continue;
    nearest = &camera;
    nearest_m2 = away_m2;
  }
  return nearest;
}

bool Camera::covers(const CameraPosition& camera, const BallState& ball) const {
  // The ball's distances from the camera in the directions of the field's two axes. A camera's view
  // is limited only towards its neighbours, not towards the outside of the field.
  const Vec2 inwards_m =
      ball.position_m.cwiseProduct(-camera.position_m.cwiseSign()) + camera.position_m.cwiseAbs();
  if (inwards_m.x() > sees_beside_m_.x() || inwards_m.y() > sees_beside_m_.y()) return false;
  // The projection onto the carpet diverges as the ball nears the camera's height.
  return parameters_.reports_height || ball.height_m <= 0.9 * camera.height_m;
}

bool Camera::happens(double share) { return share > 0.0 && chance_.uniform() < share; }

Vec2 Camera::with_noise(const Vec2& position_m, double noise_m) {
  if (noise_m <= 0.0) return position_m;
  // The random numbers are drawn in separate statements, because C++ does not fix the order in
  // which arguments are evaluated.
  const double x_m = noise_m * chance_.normal();
  const double y_m = noise_m * chance_.normal();
  return position_m + Vec2(x_m, y_m);
}

}  // namespace autoref::sim
