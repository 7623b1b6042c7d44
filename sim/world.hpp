// The simulated world: robots, ball, goals and walls as rigid bodies in the plane.
//
// It owns the ground truth: exact positions, speeds and contacts. It has no rules and makes no
// decisions; the game loop passes it commands and any placement once per camera frame. Everything
// is in SI units and field coordinates (soccer/field.hpp).
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"

namespace autoref::sim {

struct RobotState {
  int number = 0;
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
  Vec2 velocity_mps{0, 0};
  double angular_velocity_radps = 0;
};

using RobotStates = boost::container::static_vector<RobotState, kMaxRobots>;

struct BallState {
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  double height_m = 0;  // height of the lowest point
  double vertical_mps = 0;
  bool is_rolling = true;
};

struct WorldState {
  std::int64_t frame = 0;  // number of frames stepped; time is frame / frame rate
  // The robots on the field, ordered by number.
  PerSide<RobotStates> robots;
  BallState ball;
};

// A touch of the ball by a robot's hull or kicker, as ground truth.
struct Touch {
  std::int64_t frame = 0;  // state().frame after the step in which it happened
  int substep = 0;
  RobotId robot;
  Vec2 ball_m{0, 0};
  bool is_kick = false;
  Vec2 ball_mps{0, 0};      // the ball's velocity right after the touch, in the plane
  double vertical_mps = 0;  // upward component of the ball's velocity right after the touch
};

// A collision of two robots' hulls that were apart before. In these collisions, robots are round
// discs; their flat fronts are ignored.
struct RobotCollision {
  std::int64_t frame = 0;  // as in Touch
  int substep = 0;
  std::array<RobotId, 2> robots;
  std::array<Vec2, 2> velocities_mps;  // velocities just before the collision
  std::array<Vec2, 2> centres_m;       // centres just before the collision
};

class World {
 public:
  // Robots start lined up in their own halves, with the ball at the centre. `seed` selects the
  // random streams of motors and kickers. Throws std::invalid_argument if the configuration is out
  // of range.
  World(const Field& field, const Configuration& configuration, const PerSide<TeamSpec>& specs,
        std::uint64_t seed);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  // Simulates one camera frame. The new commands take effect after as many sub-steps as
  // split_latency() says; until then, the previous ones apply. Commands for robots that do not
  // exist or are off the field are ignored. Commands must be finite (asserted); they are limited to
  // what each robot can do. With `placement`, the ball is held by ball placement, which brings it
  // to the target and keeps it there; robots, kickers and dribblers do not affect it. Without
  // `placement`, the ball is free, and a robot that overlaps it pushes it out.
  void step(const PerSide<TeamCommands>& commands, const std::optional<Placement>& placement);

  // The state after the last step.
  const WorldState& state() const;

  // Touches of the ball during the last step, in order; at most 256.
  std::span<const Touch> touches() const;

  // Robot collisions during the last step, in order; at most 64.
  std::span<const RobotCollision> collisions() const;

  // Whether every position and speed is finite.
  bool is_finite() const;

  // Takes a robot off the field: it is missing from states and frames, nothing collides with it,
  // and its commands are ignored. Nothing happens if the robot is already off the field.
  void take_off(RobotId id);
  // Puts a robot back on the field, at rest. The robot must be off the field (asserted). The
  // position must be free (asserted).
  void put_on(RobotId id, const Vec2& position_m, const Vec2& heading);
  bool is_on(RobotId id) const;
  // Whether a robot can be put at this position: no robot and no ball is in the way.
  bool is_free(const Vec2& position_m) const;

  // These functions set up situations for tests and scenes. Robots that they move must be on the
  // field.
  void put_ball(const BallState& ball);
  void put_robot(RobotId id, const RobotState& state);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// The delay from frame to motion, split into the number of whole frames by which a team's view is
// delayed, and the number of sub-steps after which the resulting commands take effect.
struct LatencySplit {
  int frames = 0;
  int substeps = 0;
};
LatencySplit split_latency(const Configuration& configuration);

}  // namespace autoref::sim
