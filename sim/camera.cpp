#include "sim/camera.hpp"

#include <algorithm>

#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::sim {
namespace {

double as_float_mm(double metres) {
  return static_cast<double>(static_cast<float>(metres * 1000.0)) / 1000.0;
}

Vec2 rounded(const Vec2& position_m) {
  return {as_float_mm(position_m.x()), as_float_mm(position_m.y())};
}

Vec2 rounded_heading(const Vec2& heading, double noise_rad) {
  return heading_of(static_cast<double>(static_cast<float>(angle_of(heading) + noise_rad)));
}

// Parallax of a flying ball: where the camera's ray through the ball's centre intersects the plane
// of the centre of a ball on the carpet.
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

}  // namespace

std::array<CameraPosition, 4> camera_positions(const Field& field, double height_m) {
  const double x = field.half_length_m() / 2.0;
  const double y = field.half_width_m() / 2.0;
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
      cameras_(camera_positions(field, parameters.camera_height_m)),
      sees_beside_m_(field.half_length_m() / 2.0 + parameters.camera_overlap_m,
                     field.half_width_m() / 2.0 + parameters.camera_overlap_m),
      frame_rate_hz_(frame_rate_hz),
      chance_(RandomStream::of(seed, RandomPurpose::kCamera)) {}

void Camera::look(const WorldState& world, Frame& frame) {
  frame.number = world.frame;
  frame.time_s = static_cast<double>(world.frame) / frame_rate_hz_;
  look_at_robots(world, frame);
  look_at_ball(world, frame);
}

void Camera::look_at_robots(const WorldState& world, Frame& frame) {
  for (const Side side : kSides) {
    frame.robots[side].clear();
    for (const RobotState& robot : world.robots[side]) {
      if (misses(parameters_.robot_misses)) continue;
      const Vec2 position_m = with_noise(robot.position_m, parameters_.robot_noise_m);
      const double noise_rad =
          parameters_.robot_noise_rad > 0.0 ? parameters_.robot_noise_rad * chance_.normal() : 0.0;
      frame.robots[side].push_back(
          {robot.number, rounded(position_m), rounded_heading(robot.heading, noise_rad)});
    }
  }
}

void Camera::look_at_ball(const WorldState& world, Frame& frame) {
  frame.ball.reset();
  if (misses(parameters_.ball_misses)) return;
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
  frame.ball->position_m = rounded(with_noise(position_m, parameters_.ball_noise_m));
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
  // The ball's distances from the camera towards the field's two axes. A camera's view is limited
  // only in these directions, not outwards.
  const Vec2 inwards_m =
      ball.position_m.cwiseProduct(-camera.position_m.cwiseSign()) + camera.position_m.cwiseAbs();
  if (inwards_m.x() > sees_beside_m_.x() || inwards_m.y() > sees_beside_m_.y()) return false;
  // The projection onto the carpet diverges as the ball nears the camera's height.
  return parameters_.reports_height || ball.height_m <= 0.9 * camera.height_m;
}

bool Camera::misses(double share) { return share > 0.0 && chance_.uniform() < share; }

Vec2 Camera::with_noise(const Vec2& position_m, double noise_m) {
  if (noise_m <= 0.0) return position_m;
  // Drawn in separate statements, because C++ does not fix the order in which arguments are
  // evaluated.
  const double x_m = noise_m * chance_.normal();
  const double y_m = noise_m * chance_.normal();
  return position_m + Vec2(x_m, y_m);
}

}  // namespace autoref::sim
