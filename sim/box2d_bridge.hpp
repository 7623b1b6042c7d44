// The world's bodies, and the use of Box2D for those that can collide. Only this file and
// box2d_shapes.hpp depend on Box2D.
//
// Between contacts, a body needs no physics engine: its motion has a closed form. So the caller
// says which bodies can collide with something (`gather`). Box2D simulates only these bodies; all
// others move freely.
//
// Box2D's tolerances fit objects of 0.1 to 10 units, so one unit is 0.1 m. It computes in floats,
// which are converted from and to this project's doubles only in box2d_bridge.cpp. The bridge
// handles shapes, masses and contacts; forces and decisions come from its caller.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/side.hpp"

namespace autoref::sim {

// Pose and motion of a body. Heading and angular velocity are unused for the ball.
struct BodyState {
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
  Vec2 velocity_mps{0, 0};
  double angular_velocity_radps = 0;
};

// A collision of two robots that were apart before, with their motion just before the collision.
struct BodyCollision {
  std::array<int, 2> robots;  // indices, the lower one first
  std::array<Vec2, 2> velocities_mps;
  std::array<Vec2, 2> centres_m;
};

// A set of bodies.
struct BodySet {
  std::uint32_t robots = 0;  // one bit per robot
  bool ball = false;

  bool is_empty() const { return robots == 0 && !ball; }
  bool has_robot(int index) const { return ((robots >> index) & 1U) != 0; }
  void add_robot(int index) { robots |= 1U << index; }
};

// The longest distance that a body can move in one step: Box2D slows down faster bodies.
inline constexpr double kLongestStep_m = 0.2;

// Rotational inertia of a homogeneous disc with a robot's mass and radius.
double robot_inertia_kgm2(double mass_kg);

class Box2dBridge {
 public:
  // Creates a robot for each entry of `masses_kg`, which lists both sides' robots; each robot is
  // identified by its index in that list. All bodies are at the origin until they are placed, and
  // Box2D simulates all of them at first.
  Box2dBridge(const Field& field, const ContactParameters& contacts, double ball_mass_kg,
              std::span<const double> masses_kg);
  ~Box2dBridge();

  // The states of the bodies after the last step or placement.
  const BodyState& robot(int index) const { return robots_[static_cast<std::size_t>(index)]; }
  const BodyState& ball() const { return ball_; }

  void place_robot(int index, const BodyState& state);
  void place_ball(const Vec2& position_m, const Vec2& velocity_mps);

  // A disabled robot collides with nothing and stays at rest where it was. All robots are enabled
  // initially.
  void set_on(int index, bool is_on);
  bool is_on(int index) const { return ((off_ >> index) & 1U) == 0; }

  // Hands these bodies to Box2D for the next steps, together with those that were handed over
  // recently, since changing the set costs as much as several steps. Returns all bodies that Box2D
  // now has.
  const BodySet& gather(const BodySet& bodies);
  const BodySet& gathered() const { return gathered_; }

  // Applies a force to a robot during its next step only. A step moves a pushed robot at the mean
  // of its speeds before and after (trapezoidal rule), so the distance does not depend on the step
  // length.
  void push_robot(int index, const Vec2& force_n, double torque_nm);
  void push_robot_at(int index, const Vec2& force_n, const Vec2& point_m);
  // Changes a robot's velocity immediately.
  void strike_robot(int index, const Vec2& impulse_ns);
  void set_ball_velocity(const Vec2& velocity_mps);

  // Sets what the ball collides with in addition to the walls around the field, which always
  // confine it.
  void let_ball_meet(bool robots, bool goals);
  // A running dribbler absorbs more of an arriving ball's speed.
  void set_dribbling(int index, bool dribbles);

  // Moves the robots that Box2D does not simulate.
  void move_free_robots(double duration_s);
  // Lets Box2D move the gathered bodies and the ball.
  void step(double duration_s);

  // The robots whose hulls touched the ball during the last step, each once, in order of contact.
  std::span<const int> touching() const;

  // The robots that collided during the last step, at most 64 pairs, in order of contact.
  std::span<const BodyCollision> collisions() const;

 private:
  struct Bodies;
  // The sum of the forces on a robot during its next step.
  struct Push {
    // Half the force of push_robot(); the second half is applied after the motion.
    Vec2 half_force_n{0, 0};
    double half_torque_nm = 0;
    Vec2 force_n{0, 0};  // force of push_robot_at()
    double torque_nm = 0;
  };

  double inverse_mass(int index) const { return inverse_masses_[static_cast<std::size_t>(index)]; }
  double inverse_inertia(int index) const {
    return inverse_mass(index) * 2.0 / (kRobotRadius_m * kRobotRadius_m);
  }
  void enable_robot(int index, bool is_enabled);
  void move_freely(int index, double duration_s);
  void finish_push(int index, double duration_s);
  void step_box2d(double duration_s);
  void give_robot(int index);
  void give_ball();
  void take_robot(int index, double duration_s);
  void take_ball();

  std::unique_ptr<Bodies> bodies_;
  int count_;
  std::uint32_t off_ = 0;                   // disabled robots, one bit per robot
  BodySet enabled_;                         // bodies enabled in Box2D
  BodySet gathered_;                        // bodies that Box2D moves
  BodySet moved_;                           // bodies moved without Box2D since its last step
  std::array<int, 2 * kMaxRobots> idle_{};  // number of calls to gather() since the robot was last
                                            // requested
  int ball_idle_ = 0;
  std::array<BodyState, 2 * kMaxRobots> robots_;
  std::array<Push, 2 * kMaxRobots> pushes_;
  std::array<double, 2 * kMaxRobots> inverse_masses_{};  // in 1/kg
  BodyState ball_;
};

}  // namespace autoref::sim
