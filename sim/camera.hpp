// From the world's truth to what vision reports.
#pragma once

#include <array>
#include <cstdint>

#include "sim/configuration.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/random.hpp"

namespace autoref::sim {

// The league's four cameras, so high above the middles of the field's quarters.
std::array<CameraPosition, 4> camera_positions(const Field& field, double height_m);

// Whether the robot stands between the camera and the middle of a ball whose lowest point is at
// `height_m`. Robots are as high all over their outline as their cover.
bool hides_ball(const RobotState& robot, const Vec2& ball_m, double height_m,
                const CameraPosition& camera);

// Takes one frame per frame, put together from four cameras: each sees its quarter and
// camera_overlap_m beyond. Values are rounded to what a league vision packet holds (float
// millimetres and radians), so that a recorded game shows the same as the live one.
class Camera {
 public:
  // `seed` names the stream of noise and misses.
  Camera(const VisionParameters& parameters, const Field& field, double frame_rate_hz,
         std::uint64_t seed);

  // Fills `frame` in place: nothing is allocated.
  void look(const WorldState& world, Frame& frame);

 private:
  void look_at_robots(const WorldState& world, Frame& frame);
  void look_at_ball(const WorldState& world, Frame& frame);
  const CameraPosition* find_view(const WorldState& world) const;
  bool covers(const CameraPosition& camera, const BallState& ball) const;
  bool misses(double share);
  Vec2 with_noise(const Vec2& position_m, double noise_m);

  VisionParameters parameters_;
  std::array<CameraPosition, 4> cameras_;
  Vec2 sees_beside_m_;  // how far each sees along x and y from its own place
  double frame_rate_hz_;
  RandomStream chance_;
};

}  // namespace autoref::sim
