#include "sim/camera.hpp"

#include <algorithm>
#include <cmath>

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
      chance_(RandomStream::of(seed, RandomPurpose::kCamera)),
      errors_(parameters, field, chance_) {}

void Camera::look(const WorldState& world, Frame& frame) {
  frame.number = world.frame;
  frame.time_s = static_cast<double>(world.frame) / frame_rate_hz_;
  if (!others_.is_empty()) others_ = {};
  look_at_robots(world, frame);
  look_at_ball(world, frame);
  if (false_balls_ > 0.0) look_for_false_balls(world, frame);
}

void Camera::look_at_robots(const WorldState& world, Frame& frame) {
  for (const Side side : kSides) {
    frame.robots[side].clear();
    SeenRobots misread;
    for (const RobotState& robot : world.robots[side]) {
      if (happens(parameters_.robot_misses)) continue;
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
  if (!errors_.are_zero()) {
    const int camera = nearest_camera(robot.position_m);
    position_m += errors_.position_m(camera, robot.position_m);
    noise_rad += errors_.heading_rad(camera, robot.position_m);
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
  if (happens(parameters_.ball_misses)) return;
  const CameraPosition* camera = find_view(world);
  if (camera == nullptr) return;
  const BallState& ball = world.ball;
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
