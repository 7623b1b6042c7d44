// Converts ground truth to what vision reports.
#pragma once

#include <array>
#include <cstdint>

#include "sim/configuration.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/random.hpp"

namespace autoref::sim {

// The positions of the league's four cameras, at height_m above the centres of the field's
// quarters.
std::array<CameraPosition, 4> camera_positions(const Field& field, double height_m);

// Whether the robot hides the centre of a ball, with its lowest point at `height_m`, from the
// camera. A robot has its full height everywhere within its outline.
bool hides_ball(const RobotState& robot, const Vec2& ball_m, double height_m,
                const CameraPosition& camera);

// Takes one merged frame of four cameras per step; each camera covers its quarter and
// camera_overlap_m beyond. Values are rounded to the precision of a league vision packet (float
// millimetres and radians), so that replaying a recorded game gives the same result as the live
// one.
class Camera {
 public:
  // `seed` selects the random stream for noise and missed detections.
  Camera(const VisionParameters& parameters, const Field& field, double frame_rate_hz,
         std::uint64_t seed);

  // Fills `frame` in place; allocates nothing.
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
  Vec2 sees_beside_m_;  // half extents of a camera's view along x and y
  double frame_rate_hz_;
  RandomStream chance_;
};

}  // namespace autoref::sim
