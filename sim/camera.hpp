// Converts ground truth to the detections that vision reports, including calibration errors.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <span>

#include "sim/sim_configuration.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/random.hpp"

namespace autoref::sim {

// Systematic errors of the cameras' calibration: a constant offset plus a warp of one period over
// the field's length and width. Offset and warp each contribute half of the mean square error. The
// errors are drawn once, so that over many games no part of the field is favoured. Neighbouring
// cameras have opposite errors.
class CameraErrors {
 public:
  // Draws no random number if the parameters are 0.
  CameraErrors(const VisionParameters& parameters, const Field& field, RandomStream& chance);

  bool are_zero() const { return error_m_ == 0.0 && error_rad_ == 0.0; }

  // The position error of a camera (index as in camera_positions()) at a point of the field.
  Vec2 position_m(int camera, const Vec2& at_m) const;
  double heading_rad(int camera, const Vec2& at_m) const;

 private:
  double error_m_;
  double error_rad_;
  Vec2 waves_per_m_;  // rad/m along x and y
  Vec2 offset_m_{0, 0};
  double offset_rad_ = 0.0;
  Vec2 phases_rad_{0, 0};
  double heading_phase_rad_ = 0.0;
};

using CameraPositions = boost::container::static_vector<CameraPosition, 4>;

// The positions of the league's cameras, at height_m above the centres of the field's quarters (4),
// of its halves (2) or of the field (1).
CameraPositions camera_positions(const Field& field, int cameras, double height_m);

// Sets the ages of the cameras' captures, if cameras run freely and do not report heights: each
// captures once per frame, at a phase that is drawn for the game with this seed. A frame begins
// after the longest pause between two captures and has the time of its last capture.
void draw_capture_ages(const VisionParameters& parameters, double frame_rate_hz, std::uint64_t seed,
                       std::span<CameraPosition> cameras);

// Whether the robot hides the centre of a ball, whose lowest point is at `height_m`, from the
// camera's view. A robot has its full height everywhere within its outline.
bool hides_ball(const RobotState& robot, const Vec2& ball_m, double height_m,
                const CameraPosition& camera);

// Takes one merged frame of all cameras per step. Each camera covers its part of the field plus
// camera_overlap_m, and each robot or ball is seen by the nearest camera. Values are rounded to the
// precision of a league vision packet (float millimetres and radians), so that replaying a recorded
// game gives the same result as the live game. If there are several balls, the ball nearest to the
// one in the previous frame is chosen; log readers are more careful (league/followed_body.hpp).
class Camera {
 public:
  // `seed` selects the random stream for noise and missed detections.
  Camera(const VisionParameters& parameters, const Field& field, double frame_rate_hz,
         std::uint64_t seed);

  // Fills `frame` in place; allocates nothing.
  void look(const WorldState& world, Frame& frame);

  // Detections that the cameras reported in addition to those in the last frame: false balls and
  // robots with misread numbers.
  const OtherDetections& others() const { return others_; }

 private:
  void look_at_robots(const WorldState& world, Frame& frame);
  void add_misread(Side side, const RobotObservation& robot, Frame& frame);
  int misread_number(int number, std::span<const RobotState> team);
  bool is_missed(Side side, const RobotState& robot);
  RobotObservation observed(const RobotState& robot);
  void look_at_ball(const WorldState& world, Frame& frame);
  void look_for_false_balls(const WorldState& world, Frame& frame);
  void add_ball(BallObservation ball, Frame& frame);
  double ball_misses(const WorldState& world) const;
  BallState captured_ball(const BallState& ball, const CameraPosition& camera) const;
  const CameraPosition* find_view(const WorldState& world) const;
  int nearest_camera(const Vec2& position_m) const;
  bool covers(const CameraPosition& camera, const BallState& ball) const;
  bool happens(double share);
  Vec2 with_noise(const Vec2& position_m, double noise_m);

  VisionParameters parameters_;
  CameraPositions cameras_;
  Vec2 sees_beside_m_;  // half extents of a camera's view along x and y
  double frame_rate_hz_;
  double false_balls_;  // proportion of frames, per robot
  double robot_gaps_;   // probability that a gap begins in a frame, per robot
  RandomStream chance_;
  CameraErrors errors_;
  OtherDetections others_;
  std::optional<Vec2> last_ball_m_;  // stored only if there are false balls
  // The ball in the world's previous frame, stored only if cameras run freely.
  std::optional<BallState> former_ball_;
  std::int64_t looks_ = 0;
  // The look with which each robot's last gap ends, by number.
  PerSide<std::array<std::int64_t, kMaxRobots>> gap_ends_{};
};

}  // namespace autoref::sim
