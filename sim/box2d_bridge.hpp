// The world's Box2D bodies. Only this file and box2d_shapes.hpp depend on Box2D.
//
// Box2D's tolerances fit objects of 0.1 to 10 units, so one unit is 0.1 m. Its numbers are floats;
// the conversion from and to this project's doubles happens only in box2d_bridge.cpp. The bridge
// handles shapes, masses and contacts; forces and decisions come from its caller.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::sim {

// Pose and motion of a body. The ball's heading and angular velocity are unused.
struct BodyState {
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
  Vec2 velocity_mps{0, 0};
  double angular_velocity_radps = 0;
};

// A collision of two robots that were apart before, with their motion just before it.
struct BodyCollision {
  std::array<int, 2> robots;  // indices, the lower one first
  std::array<Vec2, 2> velocities_mps;
  std::array<Vec2, 2> centres_m;
};

// The longest distance a body can move in one step: Box2D slows down faster bodies.
inline constexpr double kLongestStep_m = 0.2;

// Rotational inertia of a homogeneous disc with a robot's mass and radius.
double robot_inertia_kgm2(double mass_kg);

class Box2dBridge {
 public:
  // Creates a robot for each entry of `masses_kg`, which lists both sides; robots are identified by
  // their index there. All bodies are at the origin until they are placed.
  Box2dBridge(const Field& field, const ContactParameters& contacts, double ball_mass_kg,
              std::span<const double> masses_kg);
  ~Box2dBridge();

  // States after the last step or placement.
  const BodyState& robot(int index) const { return robots_[static_cast<std::size_t>(index)]; }
  const BodyState& ball() const { return ball_; }

  void place_robot(int index, const BodyState& state);
  void place_ball(const Vec2& position_m, const Vec2& velocity_mps);

  // A disabled robot collides with nothing and rests where it was. All are enabled initially.
  void set_on(int index, bool is_on);
  bool is_on(int index) const { return ((off_ >> index) & 1U) == 0; }

  // Applies a force to a robot during the next step only. A step moves a pushed robot at the mean
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

  void step(double duration_s);

  // The robots whose hull touched the ball during the last step, each once, in order of contact.
  std::span<const int> touching() const;

  // The robots that collided during the last step, at most 64 pairs, in order of contact.
  std::span<const BodyCollision> collisions() const;

 private:
  struct Bodies;
  void fit_plates();
  void push_on(int index, float duration_s);
  void read_robot(int index);
  void read_ball();

  std::unique_ptr<Bodies> bodies_;
  std::vector<double> masses_kg_;
  int count_;
  std::uint32_t off_ = 0;  // one bit per robot
  std::array<BodyState, 2 * kMaxRobots> robots_;
  BodyState ball_;
};

}  // namespace autoref::sim
